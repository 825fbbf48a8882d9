// What is said of a picture on the screen.
#include "viewer/judgement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "quant/hue_loss.h"
#include "tests/random_planes.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

/// Red on the left, orange in the middle, blue on the right.
Planes three_hues() {
  Planes picture(ImageSize{30, 20});
  for (std::size_t i = 0; i < picture.size.pixels(); ++i)
    picture.set(i, i % 30 < 10   ? Rgb8{200, 0, 0}
                   : i % 30 < 20 ? Rgb8{240, 120, 0}
                                 : Rgb8{0, 0, 220});
  return picture;
}

TEST(Judgement, NamesTheHuesThatAreGone) {
  const Planes truth = three_hues();
  Planes shown = truth;
  for (std::size_t i = 0; i < shown.size.pixels(); ++i)
    if (i % 30 < 20) shown.set(i, {110, 110, 110});
  const auto found = judge(truth, shown);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->lost.size(), 2u);
  EXPECT_EQ(found->lost[0].degrees, 0);
  EXPECT_EQ(found->lost[0].name, "red");
  EXPECT_EQ(found->lost[0].pixels, 200u);
  EXPECT_EQ(found->lost[0].lost, 1);
  EXPECT_EQ(found->lost[1].name, "orange");
  const auto expected = quant::measure(truth, shown);
  EXPECT_EQ(found->metrics.psnr, expected.psnr);
  EXPECT_EQ(found->metrics.de_p95, expected.de_p95);
  EXPECT_EQ(found->metrics.hue_loss, expected.hue_loss);
  const auto lines = describe(*found);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[4], "hue 0° (red) is gone: 100 % of 200 pixels");
  EXPECT_EQ(lines[5], "hue 30° (orange) is gone: 100 % of 200 pixels");
}

TEST(Judgement, EqualPicturesAreSaidToBe) {
  const Planes truth = three_hues();
  const auto found = judge(truth, truth);
  ASSERT_TRUE(found);
  EXPECT_THAT(
      describe(*found),
      ElementsAre("PSNR infinite: equal to the true colours", StartsWith("CIEDE2000 mean 0.000"),
                  StartsWith("SSIM 1.0000"), "3 colours · hue loss 0.0 %"));
}

TEST(Judgement, StopsAndRefuses) {
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_FALSE(judge(three_hues(), three_hues(), stopped.get_token()));
  EXPECT_THROW(judge(three_hues(), Planes(ImageSize{20, 30})), std::invalid_argument);
}

TEST(HueName, IsTheNearestOnTheWheel) {
  EXPECT_STREQ(quant::hue_name(0), "red");
  EXPECT_STREQ(quant::hue_name(14), "red");
  EXPECT_STREQ(quant::hue_name(15), "orange");
  EXPECT_STREQ(quant::hue_name(240), "blue");
  EXPECT_STREQ(quant::hue_name(344), "rose");
  EXPECT_STREQ(quant::hue_name(350), "red");
  EXPECT_STREQ(quant::hue_name(360), "red");
}

}  // namespace
}  // namespace sir::viewer
