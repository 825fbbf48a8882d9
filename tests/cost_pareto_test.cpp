// The front, the medians and the order of runs of the price list.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cli/cost/pareto.h"
#include "cli/cost/timing.h"

namespace sir::cli {
namespace {

// The definition, offer by offer.
bool beaten(const Offer& offer, const std::vector<Offer>& offers) {
  for (const Offer& other : offers) {
    const bool as_good = other.time <= offer.time && other.quality >= offer.quality;
    const bool better = other.time < offer.time || other.quality > offer.quality;
    if (as_good && better) return true;
  }
  return false;
}

TEST(ParetoFront, IsWhatNoOtherOfferBeats) {
  std::mt19937 random(5);
  std::size_t on = 0, off = 0;
  for (int round = 0; round < 2000; ++round) {
    // Few different numbers, so that many are equal in one or both; some without bound.
    const auto values = 1 + random() % 12;
    std::vector<Offer> offers(random() % 20);
    for (Offer& offer : offers) {
      offer.time = static_cast<double>(random() % values);
      offer.quality = random() % 8 == 0 ? double{INFINITY} : static_cast<double>(random() % values);
    }
    const auto front = pareto_front(offers);
    ASSERT_EQ(front.size(), offers.size());
    for (std::size_t i = 0; i < offers.size(); ++i) {
      ASSERT_EQ(front[i], !beaten(offers[i], offers))
          << offers[i].time << " " << offers[i].quality << " in round " << round;
      ++(front[i] ? on : off);
    }
  }
  EXPECT_GT(on, 1000u);
  EXPECT_GT(off, 1000u);
}

TEST(Spread, HasMedianAndQuartiles) {
  const std::vector<double> five{5, 1, 4, 2, 3}, two{3, 1};
  EXPECT_EQ(spread_of(five).median, 3);
  EXPECT_EQ(spread_of(five).low, 2);
  EXPECT_EQ(spread_of(five).high, 4);
  EXPECT_EQ(spread_of(five).runs, 5u);
  EXPECT_EQ(spread_of(two).median, 2);
  EXPECT_EQ(spread_of(two).low, 1.5);
  EXPECT_EQ(spread_of(two).high, 2.5);
  EXPECT_EQ(spread_of(std::vector<double>{7}).low, 7);
  EXPECT_EQ(spread_of({}).runs, 0u);
}

TEST(Ratio, IsTakenWithinRounds) {
  // A slow spell in the second round hits both: the ratio does not see it.
  const std::vector<double> usual{1, 10, 1}, other{2, 20, 2}, once{3};
  EXPECT_EQ(ratio_of(other, usual).median, 2);
  EXPECT_EQ(ratio_of(other, usual).low, 2);
  EXPECT_EQ(ratio_of(other, usual).high, 2);
  EXPECT_EQ(ratio_of(once, usual).median, 3);
  EXPECT_EQ(ratio_of(once, usual).runs, 1u);
}

TEST(Rounds, BeginWithAnotherRowEachTime) {
  std::vector<std::size_t> order;
  const auto note = [&](std::size_t row) {
    order.push_back(row);
    return true;
  };
  EXPECT_TRUE(Rounds(3, 3)(note));
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 1, 2, 0, 2, 0, 1}));
  order.clear();
  EXPECT_TRUE(Rounds(3, 3)(note, [](std::size_t row) { return row == 1 ? std::size_t{2} : 3; }));
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 1, 2, 0, 2, 0}));
  order.clear();
  EXPECT_FALSE(Rounds(3, 3)([&](std::size_t row) { return note(row) && order.size() < 5; }));
  EXPECT_EQ(order.size(), 5u);
}

TEST(Rounds, DearRowsRunLessOften) {
  EXPECT_EQ(affordable_runs(100, 10, 5), 5u);
  EXPECT_EQ(affordable_runs(160, 10, 5), 3u);
  EXPECT_EQ(affordable_runs(640, 10, 5), 2u);
  EXPECT_EQ(affordable_runs(1e9, 10, 5), 2u);
  EXPECT_EQ(affordable_runs(1e9, 10, 1), 1u);
}

}  // namespace
}  // namespace sir::cli
