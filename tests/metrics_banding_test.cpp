// Banding on ramps, textures and edges of known make.
#include "quant/banding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "quant/ciede2000.h"
#include "quant/dither.h"
#include "quant/nearest.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

Rgb8 grey(int level) {
  const auto byte = static_cast<std::uint8_t>(level);
  return {byte, byte, byte};
}

/// A grey ramp of 512 columns, in steps of `step` levels.
Planes ramp(int step, int rows = 16) {
  Planes image(ImageSize{512, rows});
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    image.set(i, grey(static_cast<int>(i) % 512 / 2 / step * step));
  return image;
}

Planes turned(const Planes& image) {
  Planes out(ImageSize{image.size.height, image.size.width});
  const auto width = static_cast<std::size_t>(image.size.width);
  const auto height = static_cast<std::size_t>(image.size.height);
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    out.set(i % width * height + i / width, image.at(i));
  return out;
}

TEST(Banding, GrowsWithTheStepsOfARamp) {
  const Planes smooth = ramp(1);
  EXPECT_EQ(banding(smooth, smooth), 0);
  double before = 0;
  for (const int step : {2, 3, 4, 8, 16, 32, 64}) {
    const double now = banding(smooth, ramp(step));
    EXPECT_GT(now, before) << step;
    before = now;
  }
}

TEST(Banding, IsTheSameInBothDirections) {
  EXPECT_DOUBLE_EQ(banding(turned(ramp(1)), turned(ramp(8))), banding(ramp(1), ramp(8)));
}

TEST(Banding, OfASingleContourIsWhatItAdds) {
  // 8 columns, all of one level; shown with a step in the middle.
  Planes flat(ImageSize{8, 1}), stepped(ImageSize{8, 1});
  for (std::size_t i = 0; i < 8; ++i) {
    flat.set(i, grey(100));
    stepped.set(i, grey(i < 4 ? 98 : 103));
  }
  const double added = ciede2000(lab_of(grey(98)), lab_of(grey(103)));
  EXPECT_NEAR(banding(flat, stepped), added / std::sqrt(7.0), 1e-12);
}

TEST(Banding, IsNotFoundInTextures) {
  const Planes noise = test::random_planes({64, 64}, 4);
  Planes coarse = noise;
  for (auto& plane : coarse.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(byte & 0xC0);
  EXPECT_EQ(banding(noise, coarse), 0);
}

TEST(Banding, IsNotFoundAtTrueEdges) {
  Planes edge(ImageSize{32, 8}), shown(ImageSize{32, 8});
  for (std::size_t i = 0; i < edge.size.pixels(); ++i) {
    const bool right = i % 32 >= 16;
    edge.set(i, right ? Rgb8{200, 30, 30} : Rgb8{20, 40, 90});
    shown.set(i, right ? Rgb8{255, 0, 0} : Rgb8{0, 0, 255});
  }
  EXPECT_EQ(banding(edge, shown), 0);
}

TEST(Banding, IsLessWhereStepsAreDithered) {
  // Rounded up or down by an ordered threshold instead of always down.
  const Planes smooth = ramp(1);
  Planes dithered(smooth.size);
  for (std::size_t i = 0; i < smooth.size.pixels(); ++i) {
    constexpr int kThresholds[] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const std::size_t column = i % 512, row = i / 512;
    const int up = kThresholds[row % 4 * 4 + column % 4];
    dithered.set(i, grey(std::min((smooth.at(i).r + up) / 16 * 16, 255)));
  }
  EXPECT_LT(banding(smooth, dithered), 0.5 * banding(smooth, ramp(16)));
}

TEST(Banding, IsNotFoundInTheStretchesOfDither) {
  // Grey 40 and more, a level every 4 columns, shown in greys 8 levels apart: plainly, by error
  // diffusion and by place. Dither has many pairs of two and two equal pixels.
  Planes slope(ImageSize{400, 64});
  for (std::size_t i = 0; i < slope.size.pixels(); ++i)
    slope.set(i, grey(40 + static_cast<int>(i) % 400 / 4));
  std::vector<DacCode> codes;
  for (std::uint8_t code = 8; code <= 36; code += 2) codes.push_back({code, code, code});
  const Lut lut = make_lut(codes);
  const auto shown = [&](Dither kind) {
    return as_seen(slope.size, dither(slope, lut, kind, NearestSearch(lut)), lut);
  };
  const double plain = banding(slope, shown(Dither::none));
  EXPECT_LT(banding(slope, shown(Dither::floyd)), 0.1 * plain);
  EXPECT_LT(banding(slope, shown(Dither::blue_noise)), 0.3 * plain);
}

TEST(Banding, FollowsAContourThatWinds) {
  // A circle of one level more: its contour runs in all directions, and is found all around.
  Planes flat(ImageSize{64, 64}), shown(ImageSize{64, 64});
  for (std::size_t i = 0; i < flat.size.pixels(); ++i) {
    const int x = static_cast<int>(i) % 64 - 32, y = static_cast<int>(i) / 64 - 32;
    flat.set(i, grey(100));
    shown.set(i, grey(x * x + y * y < 400 ? 105 : 100));
  }
  const double added = ciede2000(lab_of(grey(100)), lab_of(grey(105)));
  const double pairs = 2 * 63 * 64, found = std::pow(banding(flat, shown) / added, 2) * pairs;
  EXPECT_GT(found, 20 * 2 * 3.14159 * 0.7);  // most of the pixels along it
}

TEST(Banding, OfTheSmallestImages) {
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{2, 1}, ImageSize{1, 3}}) {
    const Planes image = test::random_planes(size, 5);
    EXPECT_EQ(banding(image, image), 0);
  }
  EXPECT_EQ(banding(Planes(ImageSize{1, 1}), test::random_planes({1, 1}, 6)), 0);
}

}  // namespace
}  // namespace sir::quant
