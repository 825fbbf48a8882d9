// The digital-to-analogue converters of the MA120 (thesis 3.4): from a 6-bit
// code to what is seen; and those of other machines, of 1 to 8 bits.
#pragma once

#include <cstdint>

#include "quant/dac_code.h"
#include "tracer/planes.h"

namespace sir::eltek {

/// The level, 0..255, at which a code is seen: round(255 code / 63), which is
/// what a linear converter gives when code 63 is full intensity, and what the
/// choice of LUTs counts on (quant::seen_byte). Only the low 6 bits of `code`
/// are wired; a converter of 1 to 8 `bits` goes from 0 to 2^bits - 1 likewise.
/// The thesis gives the range 0..63 and no curve; linearity is our model.
std::uint8_t dac_level(std::uint8_t code, int bits = 6);

/// The colour of an entry as seen: one converter per primary.
Rgb8 dac_colour(const quant::DacCode& codes, const quant::DacBits& dac = {});

}  // namespace sir::eltek
