// Which of two pictures wins which pixel.
#include "viewer/duel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "quant/ciede2000.h"
#include "tests/random_planes.h"

namespace sir::viewer {
namespace {

constexpr ImageSize kSize{30, 20};

/// The picture with every byte moved by up to `most`.
Planes shaken(const Planes& picture, int most, unsigned seed) {
  const Planes noise = test::random_planes(picture.size, seed);
  Planes result = picture;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < picture.size.pixels(); ++i) {
      const int moved = picture.channel[c][i] + noise.channel[c][i] % (2 * most + 1) - most;
      result.channel[c][i] = static_cast<std::uint8_t>(moved < 0 ? 0 : moved > 255 ? 255 : moved);
    }
  return result;
}

TEST(Duel, EachPixelGoesToTheSmallerDifference) {
  const Planes truth = test::random_planes(kSize, 1);
  const Planes a = shaken(truth, 8, 2), b = shaken(truth, 9, 3);
  const Duel found = duel(truth, a, b);
  const auto of_a = quant::difference_map(truth, a), of_b = quant::difference_map(truth, b);
  std::uint64_t won_by_a = 0, won_by_b = 0, ties = 0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    Winner expected = Winner::tie;
    if (of_a[i] <= of_b[i] - kEqualToTheEye) expected = Winner::a, ++won_by_a;
    else if (of_b[i] <= of_a[i] - kEqualToTheEye) expected = Winner::b, ++won_by_b;
    else ++ties;
    EXPECT_EQ(found.winner[i], expected) << i;
  }
  EXPECT_EQ(found.won_by_a, won_by_a);
  EXPECT_EQ(found.won_by_b, won_by_b);
  EXPECT_EQ(found.ties, ties);
  EXPECT_GT(won_by_a, 0u);
  EXPECT_GT(won_by_b, 0u);
  EXPECT_GT(ties, 0u);
  const auto mean = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  };
  EXPECT_DOUBLE_EQ(found.mean_a, mean(of_a));
  EXPECT_DOUBLE_EQ(found.mean_b, mean(of_b));
}

TEST(Duel, TurnedRoundItIsTheOthersVictory) {
  const Planes truth = test::random_planes(kSize, 4);
  const Planes a = shaken(truth, 8, 5), b = shaken(truth, 8, 6);
  const Duel one = duel(truth, a, b), other = duel(truth, b, a);
  EXPECT_EQ(one.won_by_a, other.won_by_b);
  EXPECT_EQ(one.won_by_b, other.won_by_a);
  EXPECT_EQ(one.ties, other.ties);
  EXPECT_EQ(duel(truth, a, a).ties, kSize.pixels());
}

TEST(DuelMap, ShowsTheWinnersHueOverTheDimmedPicture) {
  Planes truth(ImageSize{6, 1});
  Duel found;
  found.size = truth.size;
  found.winner = {Winner::tie, Winner::a, Winner::b, Winner::tie, Winner::a, Winner::b};
  for (std::size_t i = 3; i < 6; ++i) truth.set(i, {255, 255, 255});  // the others are black
  const Planes map = duel_map(truth, found);
  EXPECT_EQ(map.at(0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(map.at(3), (Rgb8{102, 102, 102}));
  EXPECT_EQ(map.at(4), kColourOfA);
  EXPECT_EQ(map.at(5), kColourOfB);
  EXPECT_EQ(map.at(1), (Rgb8{0, 45, 71}));  // 2/5 of it
  EXPECT_EQ(map.at(2), (Rgb8{92, 63, 0}));
  EXPECT_THROW(duel_map(Planes(ImageSize{5, 1}), found), std::invalid_argument);
}

TEST(Duel, StopsAndRefuses) {
  const Planes truth = test::random_planes(kSize, 1);
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_TRUE(duel(truth, truth, truth, stopped.get_token()).winner.empty());
  EXPECT_THROW(duel(truth, truth, Planes(ImageSize{20, 30})), std::invalid_argument);
  EXPECT_THROW(duel(Planes(), Planes(), Planes()), std::invalid_argument);
}

TEST(Duel, IsToldByNames) {
  Duel found;
  found.winner.resize(8);
  found.won_by_a = 2;
  found.won_by_b = 5;
  found.ties = 1;
  found.mean_a = 1.25;
  found.mean_b = 0.5;
  EXPECT_EQ(
      describe(found, "median in rgb", "best"),
      (std::vector<std::string>{"A: median in rgb", "  wins 2 pixels (25.0 %), CIEDE2000 1.250",
                                "B: best", "  wins 5 pixels (62.5 %), CIEDE2000 0.500",
                                "equal to the eye (within 0.5): 1 (12.5 %)"}));
}

}  // namespace
}  // namespace sir::viewer
