// Light intensities of the three primaries (thesis 2.4.3).
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "tracer/planes.h"

namespace sir {

/// r g b; 1 is full intensity, more is allowed until a pixel is written.
template <typename T>
using Colour = glm::vec<3, T>;

/// floor(255 clamp(I,0,1) + 1/2); what is no number becomes 0.
template <typename T>
std::uint8_t to_byte(T intensity) {
  const T clamped = intensity > 0 ? std::min(intensity, T(1)) : T(0);
  return static_cast<std::uint8_t>(255 * clamped + T(0.5));  // a floor: it is not negative
}

template <typename T>
Rgb8 to_rgb8(const Colour<T>& colour) {
  return {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b)};
}

}  // namespace sir
