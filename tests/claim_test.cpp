// The thesis's claim (4.4): RGB spoils its Whitted image, HSV does not. On our whitted with a
// small ball of any colour this is so where boxes are split by pixels or breadth first. It is
// not where the longest box is split first, and the thesis leaves the order open.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/claim_ball.h"

namespace sir::test {
namespace {

using quant::Space;
using quant::SplitOrder;

struct Coloured {
  std::string name;
  glm::dvec3 colour;
};

class Claim : public testing::TestWithParam<Coloured> {
 protected:
  BallImage scene{SIR_CLAIM "/ball", {GetParam().colour}, {320, 240}};
};

INSTANTIATE_TEST_SUITE_P(Ball, Claim,
                         testing::Values(Coloured{"Green", {0.1, 0.7, 0.15}},
                                         Coloured{"Violet", {0.5, 0.1, 0.7}},
                                         Coloured{"Blue", {0.1, 0.2, 0.8}},
                                         Coloured{"Orange", {0.9, 0.4, 0.05}}),
                         [](const auto& ball) { return ball.param.name; });

TEST_P(Claim, TheBallIsSmallAndTheImageNeedsAChoice) {
  EXPECT_GT(scene.pixels(), 50u);
  EXPECT_LT(scene.pixels(), scene.image().size.pixels() / 900);
  EXPECT_GT(quant::occupied_cells(scene.image()).hsv, quant::kLutEntries);
}

TEST_P(Claim, HoldsWhereTheBoxWithMostPixelsIsSplit) {
  const BallLoss rgb = scene.loss(Space::rgb, SplitOrder::pixels);
  const BallLoss hsv = scene.loss(Space::hsv, SplitOrder::pixels);
  EXPECT_GT(rgb.ball, 2 * hsv.ball);
  EXPECT_GT(rgb.hue, 3 * hsv.hue);
}

TEST_P(Claim, HoldsWhereBoxesAreSplitInTurn) {
  const BallLoss rgb = scene.loss(Space::rgb, SplitOrder::breadth);
  const BallLoss hsv = scene.loss(Space::hsv, SplitOrder::breadth);
  EXPECT_GT(rgb.ball, 1.5 * hsv.ball);
  EXPECT_GT(rgb.hue, 2.5 * hsv.hue);
}

TEST_P(Claim, DoesNotHoldWhereTheLongestBoxIsSplit) {
  const BallLoss rgb = scene.loss(Space::rgb, SplitOrder::longest);
  EXPECT_LT(rgb.ball, scene.loss(Space::hsv, SplitOrder::longest).ball);
  // RGB then keeps the ball better than HSV by pixels does, which the claim praises.
  EXPECT_LT(rgb.ball, scene.loss(Space::hsv, SplitOrder::pixels).ball);
}

TEST_P(Claim, IsPaidForInTheRestOfTheImage) {
  for (const SplitOrder order : {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest})
    EXPECT_GT(scene.loss(Space::hsv, order).image, 1.2 * scene.loss(Space::rgb, order).image);
}

// The alarm is about hues of the whole image, so the ball must be alone with its own: blue is
// the sky's too, and orange the board's.
TEST(ClaimAlarm, NamesTheBallsHueInRgbAndNotInHsv) {
  for (const glm::dvec3& colour : {glm::dvec3(0.1, 0.7, 0.15), glm::dvec3(0.5, 0.1, 0.7)}) {
    const BallImage scene{SIR_CLAIM "/ball", {colour}, {320, 240}};
    const auto alarmed = [&](Space space) {
      const auto alarms = scene.loss(space, SplitOrder::pixels).alarms;
      return std::any_of(alarms.begin(), alarms.end(),
                         [&](int plane) { return scene.hues().contains(plane); });
    };
    EXPECT_TRUE(alarmed(Space::rgb));
    EXPECT_FALSE(alarmed(Space::hsv));
  }
}

}  // namespace
}  // namespace sir::test
