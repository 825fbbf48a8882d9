// What a picture makes of a LUT: how often each entry is used, in which orders a person may want to
// see them, and how the primaries are spread before and after (thesis 3.4.1, 3.5 b).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::viewer {

struct LutUsage {
  std::array<std::uint64_t, quant::kLutEntries> pixels{};  ///< that take each entry
  std::size_t unused = 0;                                  ///< entries that no pixel takes
  std::size_t repeated = 0;  ///< entries that are seen as an earlier one is
};

/// Counts the entries that the pixels take.
LutUsage lut_usage(const quant::Lut& lut, std::span<const std::uint8_t> indices);

/// How a panel puts the entries side by side. The LUT itself keeps its order.
enum class EntryOrder : std::uint8_t {
  index,     ///< as in the LUT
  pixels,    ///< the most used first
  hue,       ///< by hue from red on, then value, dark first; greys before all hues
  lightness  ///< by CIELAB's L, dark first
};

/// All 256 indices in that order; equal ones keep the LUT's.
std::array<std::uint8_t, quant::kLutEntries> entry_order(const quant::Lut& lut,
                                                         const LutUsage& usage, EntryOrder order);

/// Pixels by the value of each primary; bin i of n holds the bytes 256 i / n and those up to the
/// next bin's.
using PrimaryHistogram = std::array<std::vector<std::uint64_t>, 3>;

/// `bins`: a divisor of 256, such as 64, one for each code of the DAC, or 256; else
/// std::invalid_argument.
PrimaryHistogram primary_histogram(const Planes& picture, std::size_t bins);

}  // namespace sir::viewer
