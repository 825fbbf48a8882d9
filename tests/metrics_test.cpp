// The sum of the metrics, PSNR and the heat map; extreme images.
#include "quant/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quant/ciede2000.h"
#include "quant/heat_map.h"
#include "quant/psnr.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

Planes plain(ImageSize size, Rgb8 colour) {
  Planes image(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) image.set(i, colour);
  return image;
}

TEST(Psnr, IsThatOfItsFormula) {
  const Planes a = plain({4, 3}, {10, 20, 30}), b = plain({4, 3}, {13, 20, 26});
  EXPECT_DOUBLE_EQ(mean_square_error(a, b), 25.0 / 3);
  EXPECT_DOUBLE_EQ(psnr(a, b).value(), 10 * std::log10(65025 / (25.0 / 3)));
  EXPECT_DOUBLE_EQ(psnr(plain({2, 2}, {0, 0, 0}), plain({2, 2}, {255, 255, 255})).value(), 0);
}

TEST(Measure, EqualImagesOfAnySize) {
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{5, 2}, ImageSize{64, 48}}) {
    const Planes image = test::random_planes(size, 31);
    const ImageMetrics m = measure(image, image);
    EXPECT_EQ(m.psnr, std::nullopt);
    EXPECT_EQ(m.rmse, 0);
    EXPECT_EQ(m.de_mean, 0);
    EXPECT_EQ(m.de_p95, 0);
    EXPECT_EQ(m.de_max, 0);
    EXPECT_DOUBLE_EQ(m.ssim, 1);
    EXPECT_GE(m.colours, 1u);
    EXPECT_EQ(m.banding, 0);
    EXPECT_EQ(m.hue_loss, 0);
  }
}

TEST(Measure, TellsMeanPercentileAndGreatest) {
  // 100 pixels of black, of which 4, 5 or 6 are shown in grey.
  const Planes black = plain({10, 10}, {0, 0, 0});
  const double step = ciede2000(lab_of(Rgb8{0, 0, 0}), lab_of(Rgb8{90, 90, 90}));
  for (const std::size_t wrong : {4u, 5u, 6u}) {
    Planes shown = black;
    for (std::size_t i = 0; i < wrong; ++i) shown.set(17 * i, {90, 90, 90});
    const ImageMetrics m = measure(black, shown);
    EXPECT_NEAR(m.de_mean, step * static_cast<double>(wrong) / 100, 1e-12);
    EXPECT_DOUBLE_EQ(m.de_p95, wrong > 5 ? step : 0);
    EXPECT_DOUBLE_EQ(m.de_max, step);
    EXPECT_EQ(m.colours, 2u);
  }
}

TEST(Measure, CountsTheShownColours) {
  Planes shown(ImageSize{16, 16});
  for (std::size_t i = 0; i < 256; ++i) shown.set(i, {static_cast<std::uint8_t>(i / 2), 0, 3});
  EXPECT_EQ(measure(plain({16, 16}, {1, 2, 3}), shown).colours, 128u);
}

TEST(Measure, AOnePixelImage) {
  const ImageMetrics m = measure(plain({1, 1}, {255, 0, 0}), plain({1, 1}, {120, 120, 120}));
  EXPECT_GT(m.de_mean, 10);
  EXPECT_EQ(m.de_mean, m.de_p95);
  EXPECT_EQ(m.de_mean, m.de_max);
  EXPECT_LT(m.ssim, 1);
  EXPECT_EQ(m.hue_loss, 1);
}

TEST(Measure, RefusesImagesThatCannotBeCompared) {
  EXPECT_THROW(measure(plain({4, 3}, {}), plain({3, 4}, {})), std::invalid_argument);
  EXPECT_THROW(measure(Planes(), Planes()), std::invalid_argument);
  EXPECT_THROW(heat_map(plain({4, 3}, {}), plain({4, 4}, {})), std::invalid_argument);
}

TEST(ShownThrough, IsTheNearestEntryAsSeen) {
  Planes image(ImageSize{2, 1});
  image.set(0, {250, 9, 3});
  image.set(1, {7, 7, 90});
  const Planes shown =
      shown_through(image, make_lut(std::vector<DacCode>{{0, 0, 20}, {63, 0, 0}, {63, 63, 63}}));
  EXPECT_EQ(shown.at(0), (Rgb8{255, 0, 0}));
  EXPECT_EQ(shown.at(1), (Rgb8{0, 0, 81}));
}

TEST(HeatMap, GrowsLighterAllTheWay) {
  EXPECT_EQ(heat_colour(0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(heat_colour(kWhiteHot / 2), (Rgb8{230, 0, 0}));
  EXPECT_EQ(heat_colour(kWhiteHot), (Rgb8{255, 255, 255}));
  EXPECT_EQ(heat_colour(1000), (Rgb8{255, 255, 255}));
  double before = -1;
  for (int i = 0; i <= 100; ++i) {
    const double lightness = lab_of(heat_colour(kWhiteHot * i / 100)).l;
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
}

TEST(HeatMap, ShowsEachPixelsDifference) {
  const Planes a = test::random_planes({6, 5}, 32);
  Planes b = a;
  b.set(7, {1, 2, 3});
  const Planes map = heat_map(a, b);
  for (std::size_t i = 0; i < 30; ++i)
    EXPECT_EQ(map.at(i),
              i == 7 ? heat_colour(ciede2000(lab_of(a.at(7)), lab_of(b.at(7)))) : (Rgb8{0, 0, 0}));
}

}  // namespace
}  // namespace sir::quant
