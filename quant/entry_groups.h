// What each entry of a LUT stands for: the pixels that take it. It is all that can be said of an
// entry of the method `best`, whose swaps and nudges leave no lineage, and as true of the
// thesis's (3.5 b).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The pixels that are shown by one entry.
struct EntryGroup {
  std::uint64_t pixels = 0;
  std::size_t colours = 0;  ///< different ones among them
  glm::dvec3 mean{0};       ///< of their bytes
  double spread = 0;        ///< root of their mean squared distance from the mean, in bytes
};

/// The groups of all entries. `indices` are the pixels'; std::invalid_argument where their number
/// is not the image's.
std::array<EntryGroup, kLutEntries> entry_groups(const Planes& image,
                                                 std::span<const std::uint8_t> indices);

/// Of the entries that are seen as another colour than `index`, the one nearest to it by the
/// bytes; ties take the lowest index. None where the LUT has one colour.
std::optional<std::uint8_t> nearest_other(const Lut& lut, std::uint8_t index);

/// The squared distance of the thesis's search (3.5 b), of the bytes.
constexpr int squared_distance(Rgb8 a, Rgb8 b) {
  const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

}  // namespace sir::quant
