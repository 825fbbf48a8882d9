// A value for each colour that comes up.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "tracer/planes.h"

namespace sir::quant {

/// A value for each of the 2^24 colours, kept in cubes of 16 levels a side that are made, full of
/// the initial value, when their first colour comes: images hold their colours close together,
/// and so they lie close together here.
template <typename Value>
class ColourTable {
 public:
  explicit ColourTable(const Value& initial) : initial_(initial), cubes_(16 * 16 * 16) {}

  Value& operator[](Rgb8 colour) {
    const auto joined = [](int r, int g, int b) {
      return static_cast<std::size_t>(r << 8 | g << 4 | b);
    };
    auto& cube = cubes_[joined(colour.r >> 4, colour.g >> 4, colour.b >> 4)];
    if (!cube) {
      cube = std::make_unique<Cube>();
      cube->fill(initial_);
    }
    return (*cube)[joined(colour.r & 15, colour.g & 15, colour.b & 15)];
  }

 private:
  using Cube = std::array<Value, 16 * 16 * 16>;
  Value initial_;
  std::vector<std::unique_ptr<Cube>> cubes_;
};

}  // namespace sir::quant
