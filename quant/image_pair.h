// What two images must have in common to be compared, and colours as numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "tracer/planes.h"

namespace sir::quant {

/// Throws std::invalid_argument unless both images have one size and pixels.
inline void require_pair(const Planes& reference, const Planes& shown) {
  if (reference.size != shown.size)
    throw std::invalid_argument("images of different sizes cannot be compared");
  if (reference.size.pixels() == 0)
    throw std::invalid_argument("images without pixels cannot be compared");
}

/// A stored colour as a number of 24 bits, r highest.
constexpr std::uint32_t packed(Rgb8 colour) {
  return std::uint32_t{colour.r} << 16 | std::uint32_t{colour.g} << 8 | colour.b;
}

constexpr Rgb8 unpacked(std::uint32_t number) {
  return {static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
          static_cast<std::uint8_t>(number)};
}

/// A colour of an image, and how many pixels have it.
struct ColourCount {
  Rgb8 colour;
  std::uint64_t pixels = 0;
};

/// The different colours of an image, by their numbers.
inline std::vector<ColourCount> distinct_colours(const Planes& image) {
  std::vector<std::uint32_t> numbers(image.size.pixels());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = packed(image.at(i));
  std::sort(numbers.begin(), numbers.end());
  std::vector<ColourCount> colours;
  for (const std::uint32_t number : numbers) {
    if (colours.empty() || packed(colours.back().colour) != number)
      colours.push_back({unpacked(number), 0});
    ++colours.back().pixels;
  }
  return colours;
}

}  // namespace sir::quant
