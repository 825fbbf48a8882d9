// Sets of LUT entries.
#pragma once

#include <bitset>
#include <string_view>

#include "quant/lut.h"

namespace sir::quant {

/// Some of a LUT's entries: bit i stands for entry i. A set of reserved entries holds those
/// that no pixel may take, so that text, a pointer or another picture can have them.
using IndexSet = std::bitset<kLutEntries>;

/// Reads indices and ranges, both ends included, separated by commas: "0-15,255". False, and
/// `set` as it was, where the text is nothing of the kind, an index is not within 0..255 or a
/// range runs backwards.
bool parse_indices(std::string_view text, IndexSet& set);

}  // namespace sir::quant
