// Sources of samples made in code, for the tests of antialiasing.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tracer/sample_points.h"

namespace sir::test {

/// The colour of each point of a made-up screen.
using Painting = Rgb8 (*)(ScreenPoint);

/// Another colour at every point: a hash of it.
inline Rgb8 noise(ScreenPoint at) {
  auto h = static_cast<std::uint64_t>(static_cast<std::int64_t>(at.x * 64)) * 0x9e3779b97f4a7c15;
  h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(static_cast<std::int64_t>(at.y * 64));
  h *= 0xbf58476d1ce4e5b9;
  h = (h ^ (h >> 32)) * 0x94d049bb133111eb;
  return {static_cast<std::uint8_t>(h >> 40), static_cast<std::uint8_t>(h >> 48),
          static_cast<std::uint8_t>(h >> 56)};
}

/// Discs, edges and a slow change of colour.
inline Rgb8 shapes(ScreenPoint at) {
  const double u = at.x - 31.3, v = at.y - 22.7, r2 = u * u + v * v;
  Rgb8 colour{static_cast<std::uint8_t>(static_cast<int>(at.x) & 127), 10, 20};
  if (r2 < 400) colour = {200, static_cast<std::uint8_t>(r2 / 4), 0};
  if (r2 < 80 && at.x + 0.37 * at.y > 37) colour = {0, 0, 255};
  return colour;
}

/// A source that paints, and remembers what it was asked for.
struct Recorder {
  Painting painting;
  std::set<ScreenPoint> asked;
  std::uint64_t times = 0;

  SampleSource source() {
    return [this](std::span<const ScreenPoint> points, std::span<Rgb8> colours, const Share&) {
      for (std::size_t p = 0; p < points.size(); ++p) {
        colours[p] = painting(points[p]);
        asked.insert(points[p]);
      }
      times += points.size();
      return true;
    };
  }
};

/// That `part` is what `region` cuts out of `whole`.
inline void expect_crop(const Planes& part, const Planes& whole, const Region& region) {
  ASSERT_EQ(part.size, (ImageSize{region.width, region.height}));
  for (int j = 0; j < region.height; ++j)
    for (int i = 0; i < region.width; ++i) {
      const int there = (region.y + j) * whole.size.width + region.x + i;
      ASSERT_EQ(part.at(static_cast<std::size_t>(j * region.width + i)),
                whole.at(static_cast<std::size_t>(there)))
          << i << " " << j;
    }
}

}  // namespace sir::test
