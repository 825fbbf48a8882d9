// A DAC's bits in words: on the command line and in messages.
#pragma once

#include <string>
#include <string_view>

#include "quant/dac_code.h"

namespace sir::quant {

/// Reads "R,G,B", the bits of each primary, 1 to 8 each, or one number for all three. False,
/// and `dac` as it was, where the text is nothing of the kind.
bool parse_bits(std::string_view text, DacBits& dac);

/// The bits as parse_bits reads them: "5,6,5".
std::string bits_text(const DacBits& dac);

}  // namespace sir::quant
