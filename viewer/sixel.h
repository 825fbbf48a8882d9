// The screen as sixel graphics, for terminals that show them (DEC STD 070, VT340). The thesis has
// no terminals; its registers, though, are the same idea: a table of colours and indices into it.
#pragma once

#include <string>

#include "eltek/screen.h"

namespace sir::viewer {

/// The escape sequence, from DCS to ST, that draws the screen where the cursor stands. Index i of
/// the screen is colour register i, equal colours too; only registers that a pixel has are defined.
///
/// A register's primaries are given in percent, so that the bytes that a terminal makes of them are
/// as near as can be, at most 2 away, whether it rounds or cuts off. The nearest of a 6-bit DAC's
/// 64 codes is then always the code that was shown. A finer DAC's codes do not all survive: 101
/// levels are not 256.
///
/// A terminal with fewer than 256 registers (the VT340 had 16) shows colours of its own choice.
/// Throws std::invalid_argument for a screen without pixels.
std::string sixel(const eltek::IndexedScreen& screen);

}  // namespace sir::viewer
