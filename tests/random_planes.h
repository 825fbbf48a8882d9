// Images of noise.
#pragma once

#include <random>

#include "tracer/planes.h"

namespace sir::test {

/// Every byte at random; the same for the same seed.
inline Planes random_planes(ImageSize size, unsigned seed) {
  std::mt19937 random(seed);
  Planes planes(size);
  for (auto& plane : planes.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(random());
  return planes;
}

}  // namespace sir::test
