// The screen as coloured half blocks, for terminals that have 24-bit colours and no graphics. The
// thesis has no terminals.
#pragma once

#include <string>

#include "eltek/screen.h"

namespace sir::viewer {

/// By how much a screen of this width is scaled down to fit `columns` characters: the least whole
/// factor. 1 where it fits.
int half_block_factor(int width, int columns);

/// Lines of the character U+2580 (upper half block), its foreground the upper pixel, its background
/// the lower one, by SGR 38;2 and 48;2; each line ends with a reset. One pixel is the mean, in
/// light in proportion to its energy, of a square of half_block_factor pixels a side, or of what
/// the screen has of it. Of an odd number of rows the last line has no background. Throws
/// std::invalid_argument for a screen without pixels and for fewer than 1 column.
std::string half_blocks(const eltek::Screen& screen, int columns);

}  // namespace sir::viewer
