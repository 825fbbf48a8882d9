// Entries of a LUT that are given, and how the command line writes them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "quant/dac_code.h"

namespace sir::quant {

/// An entry that is given.
struct Pin {
  std::optional<std::size_t> index;  ///< none: the lowest that is neither pinned nor reserved
  DacCode code{};
  friend bool operator==(const Pin&, const Pin&) = default;
};

/// Reads "R,G,B" or "INDEX=R,G,B": codes from 0 to 255, whatever the DAC, and an index from 0 to
/// 255. False, and `pin` as it was, where the text is nothing of the kind.
bool parse_pin(std::string_view text, Pin& pin);

/// As parse_pin reads it.
std::string pin_text(const Pin& pin);

}  // namespace sir::quant
