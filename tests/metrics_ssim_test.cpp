// SSIM against scikit-image's values, and its bounds.
#include "quant/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/random_planes.h"

namespace sir::quant {
namespace {

/// The congruential generator of tests/oracle/ssim_values.py.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : state_(seed) {}
  int operator()(int below) {
    state_ = 1664525u * state_ + 1013904223u;
    return static_cast<int>(state_ >> 24) % below;
  }

 private:
  std::uint32_t state_;
};

struct Case {
  int width, height;
  std::uint32_t seed;
  int noise, step, shown_noise;
  double ssim;
};

Planes image_of(const Case& a) {
  Planes image(ImageSize{a.width, a.height});
  Noise noise(a.seed);
  for (int c = 0; c < 3; ++c)
    for (int j = 0, at = 0; j < a.height; ++j)
      for (int i = 0; i < a.width; ++i, ++at)
        image.channel[static_cast<std::size_t>(c)][static_cast<std::size_t>(at)] =
            static_cast<std::uint8_t>(2 * i + 3 * j + 50 * c + noise(a.noise));
  return image;
}

Planes shown_of(const Case& a, Planes image) {
  Noise noise(a.seed + 1000);
  for (auto& plane : image.channel)
    for (auto& byte : plane)
      byte =
          static_cast<std::uint8_t>(std::min(255, byte / a.step * a.step + noise(a.shown_noise)));
  return image;
}

// tests/oracle/ssim_values.py.
constexpr Case kCases[] = {
    {64, 48, 1, 1, 4, 1, 0.992874065924},    {64, 48, 2, 1, 32, 1, 0.659416956046},
    {33, 20, 3, 40, 8, 9, 0.972185012974},   {7, 7, 4, 256, 16, 64, 0.952534961543},
    {9, 50, 5, 256, 1, 256, 0.507180128074}, {120, 7, 6, 3, 64, 2, 0.431358717368},
};

TEST(Ssim, EqualsThatOfScikitImage) {
  for (const Case& a : kCases) {
    const Planes image = image_of(a);
    EXPECT_NEAR(ssim(image, shown_of(a, image)), a.ssim, 1e-9) << a.seed;
  }
}

TEST(Ssim, IsOneForEqualImagesOfAnySize) {
  for (const ImageSize size :
       {ImageSize{1, 1}, ImageSize{1, 30}, ImageSize{6, 6}, ImageSize{7, 8}, ImageSize{40, 3}}) {
    const Planes image = test::random_planes(size, 3);
    EXPECT_DOUBLE_EQ(ssim(image, image), 1) << size.width << 'x' << size.height;
  }
}

TEST(Ssim, OfOnePixelComparesLevelsAlone) {
  Planes black(ImageSize{1, 1}), grey(ImageSize{1, 1});
  grey.set(0, {100, 100, 100});
  const double c1 = 2.55 * 2.55;
  EXPECT_NEAR(ssim(black, grey), c1 / (100 * 100 + c1), 1e-12);
}

TEST(Ssim, OfAnImageBelowTheWindowHasOneWindow) {
  // Mean 10 and 30, variances 200 and 200, covariance -200.
  Planes a(ImageSize{2, 1}), b(ImageSize{2, 1});
  a.set(0, {0, 0, 0}), a.set(1, {20, 20, 20});
  b.set(0, {40, 40, 40}), b.set(1, {20, 20, 20});
  const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
  EXPECT_NEAR(ssim(a, b), (600 + c1) * (c2 - 400) / ((1000 + c1) * (400 + c2)), 1e-12);
}

}  // namespace
}  // namespace sir::quant
