// Images of 640x480 for the benchmark programs, where none are given.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "tracer/planes.h"

namespace sir::bench {

inline std::uint8_t byte_of(double intensity) {
  return static_cast<std::uint8_t>(std::floor(255 * std::clamp(intensity, 0.0, 1.0) + 0.5));
}

/// Shaded balls of many hues on a plain background, like a render.
inline Planes balls() {
  Planes image(ImageSize{640, 480});
  for (int j = 0; j < 480; ++j)
    for (int i = 0; i < 640; ++i) {
      const double x = (i % 160 - 80) / 75.0, y = (j % 160 - 80) / 75.0;
      const int ball = j / 160 * 4 + i / 160;
      const double inside = 1 - x * x - y * y;
      if (inside < 0) {
        image.set(static_cast<std::size_t>(j * 640 + i), {40, 60, 90});
        continue;
      }
      const double light = std::max(0.0, 0.6 * std::sqrt(inside) - 0.5 * x - 0.6 * y);
      const double shine = 0.6 * std::pow(light, 40);
      const auto primary = [&](int phase) {
        return byte_of((0.5 + 0.5 * std::cos(ball * 0.55 + 2.1 * phase)) * (0.15 + light) + shine);
      };
      image.set(static_cast<std::size_t>(j * 640 + i), {primary(0), primary(1), primary(2)});
    }
  return image;
}

/// The balls with the grain of a photograph.
inline Planes grainy_balls() {
  Planes image = balls();
  std::mt19937 random(1989);
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = byte_of((byte + static_cast<double>(random() % 17) - 8) / 255);
  return image;
}

inline Planes noise() {
  Planes image(ImageSize{640, 480});
  std::mt19937 random(1989);
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(random() >> 24);
  return image;
}

}  // namespace sir::bench
