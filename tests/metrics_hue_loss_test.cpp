// Hue loss: what raises an alarm and what does not.
#include "quant/hue_loss.h"

#include <gmock/gmock.h>

#include "quant/color_space.h"
#include "quant/grid.h"

namespace sir::quant {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Rgb8 of_hue(double degrees, double s = 0.8, double v = 0.8) {
  const Rgb c = hsv_to_rgb({degrees, s, v});
  const auto byte = [](double x) { return static_cast<std::uint8_t>(255 * x + 0.5); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

constexpr Rgb8 kGrey{128, 128, 128};
constexpr ImageSize kSize{20, 10};

Planes plain(Rgb8 colour) {
  Planes image(kSize);
  for (std::size_t i = 0; i < image.size.pixels(); ++i) image.set(i, colour);
  return image;
}

/// With a square of 3x3 pixels at (5, 2).
Planes with_object(Planes image, Rgb8 colour) {
  for (std::size_t j = 2; j < 5; ++j)
    for (std::size_t i = 5; i < 8; ++i) image.set(j * 20 + i, colour);
  return image;
}

TEST(HueLoss, OfEqualImagesIsNone) {
  const Planes image = with_object(plain(of_hue(240)), of_hue(120));
  const HueLoss loss = hue_loss(image, image);
  ASSERT_EQ(loss.planes.size(), 2u);
  EXPECT_EQ(loss.planes[0].plane, 12);
  EXPECT_EQ(loss.planes[0].pixels, 9u);
  EXPECT_EQ(loss.planes[0].lost, 0);
  EXPECT_EQ(loss.planes[1].plane, 24);
  EXPECT_EQ(loss.planes[1].pixels, 191u);
  EXPECT_EQ(loss.weighted, 0);
  EXPECT_THAT(loss.alarms, IsEmpty());
}

TEST(HueLoss, ASmallObjectThatTurnsGreyRaisesAnAlarm) {
  const Planes background = plain(of_hue(240));
  const HueLoss loss =
      hue_loss(with_object(background, of_hue(120)), with_object(background, kGrey));
  EXPECT_THAT(loss.alarms, ElementsAre(12));
  EXPECT_EQ(loss.planes[0].lost, 1);
  EXPECT_DOUBLE_EQ(loss.weighted, 9.0 / 200);
}

TEST(HueLoss, ASmallObjectThatTakesItsBackgroundsHueRaisesAnAlarm) {
  const Planes background = plain(of_hue(30));
  const HueLoss loss = hue_loss(with_object(background, of_hue(0)), background);
  EXPECT_THAT(loss.alarms, ElementsAre(0));
}

TEST(HueLoss, DriftToANeighbouringPlaneIsCountedButRaisesNoAlarm) {
  for (const double to : {230.0, 250.0}) {
    const HueLoss loss = hue_loss(plain(of_hue(240)), plain(of_hue(to)));
    EXPECT_EQ(loss.weighted, 1);
    EXPECT_THAT(loss.alarms, IsEmpty());
  }
  // Red's neighbours are on either side of 360 degrees.
  EXPECT_THAT(hue_loss(plain(of_hue(0)), plain(of_hue(350))).alarms, IsEmpty());
  EXPECT_THAT(hue_loss(plain(of_hue(350)), plain(of_hue(0))).alarms, IsEmpty());
  EXPECT_THAT(hue_loss(plain(of_hue(0)), plain(of_hue(340))).alarms, ElementsAre(0));
}

TEST(HueLoss, AStepOverTheBorderOfGreyRaisesNoAlarm) {
  const Planes coloured = plain(of_hue(60, 0.21, 0.8)), pale = plain(of_hue(60, 0.19, 0.8));
  const HueLoss loss = hue_loss(coloured, pale);
  EXPECT_EQ(loss.weighted, 1);
  EXPECT_THAT(loss.alarms, IsEmpty());
  EXPECT_THAT(hue_loss(plain(of_hue(60, 0.5, 0.8)), plain(kGrey)).alarms, ElementsAre(6));
}

TEST(HueLoss, HalfOfAPlaneIsTheLimit) {
  for (const std::size_t rows : {4u, 5u}) {
    const Planes red = plain(of_hue(0));
    Planes shown = red;
    for (std::size_t i = 0; i < rows * 20; ++i) shown.set(i, of_hue(180));
    EXPECT_EQ(hue_loss(red, shown).alarms.size(), rows == 5 ? 1u : 0u);
  }
}

TEST(HueLoss, ScatteredPixelsRaiseNoAlarm) {
  Planes image = plain(kGrey);
  for (std::size_t i = 0; i < image.size.pixels(); i += 3) image.set(i, of_hue(300));
  const HueLoss loss = hue_loss(image, plain(kGrey));
  EXPECT_EQ(loss.weighted, 1);
  EXPECT_THAT(loss.alarms, IsEmpty());
}

TEST(HueLoss, TheEndOfARowDoesNotTouchTheNextRow) {
  // Two columns at the right edge's and the left edge's pixels only.
  Planes image = plain(kGrey);
  for (std::size_t j = 0; j < 10; ++j) {
    image.set(j * 20, of_hue(300));
    image.set(j * 20 + 19, of_hue(300));
  }
  EXPECT_THAT(hue_loss(image, plain(kGrey)).alarms, IsEmpty());
}

TEST(HueLoss, OfGreysIsNotWeighed) {
  const HueLoss loss = hue_loss(plain(kGrey), plain(of_hue(0)));
  ASSERT_EQ(loss.planes.size(), 1u);
  EXPECT_EQ(loss.planes[0].plane, HsvGrid().grey_plane());
  EXPECT_EQ(loss.planes[0].lost, 1);
  EXPECT_EQ(loss.weighted, 0);
  EXPECT_THAT(loss.alarms, IsEmpty());
}

TEST(HueLoss, OfASinglePixel) {
  Planes red(ImageSize{1, 1}), grey(ImageSize{1, 1});
  red.set(0, of_hue(0));
  grey.set(0, kGrey);
  EXPECT_THAT(hue_loss(red, grey).alarms, ElementsAre(0));
}

}  // namespace
}  // namespace sir::quant
