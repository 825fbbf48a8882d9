// A value for each colour that comes up.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "tracer/planes.h"

namespace sir::quant {

/// A value for each of the 2^24 colours, in cubes of 16 levels a side that are made, full of the
/// initial value, when their first colour comes. Within a cube, cubes of 4 levels lie together:
/// who asks for a colour asks for those around it next, and finds them in the cache.
template <typename Value>
class ColourTable {
 public:
  explicit ColourTable(const Value& initial) : initial_(initial), cubes_(kCubes) {}

  /// Where a colour lies among all; to go through many colours in this order is fastest.
  static std::size_t place(Rgb8 colour) {
    return digit(colour, 6) << 18 | digit(colour, 4) << 12 | digit(colour, 2) << 6 |
           digit(colour, 0);
  }

  Value& operator[](Rgb8 colour) {
    const std::size_t at = place(colour);
    auto& cube = cubes_[at / kCubeColours];
    if (!cube) {
      cube = std::make_unique<Cube>();
      cube->fill(initial_);
    }
    return (*cube)[at % kCubeColours];
  }

 private:
  static constexpr std::size_t kCubes = 4096, kCubeColours = 4096;
  using Cube = std::array<Value, kCubeColours>;

  /// Two bits of each primary, from bit `low` on.
  static std::size_t digit(Rgb8 colour, int low) {
    return static_cast<std::size_t>((colour.r >> low & 3) << 4 | (colour.g >> low & 3) << 2 |
                                    (colour.b >> low & 3));
  }

  Value initial_;
  std::vector<std::unique_ptr<Cube>> cubes_;
};

}  // namespace sir::quant
