#include "eltek/light_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace sir::eltek {
namespace {

/// Pixels in, pixels out, spot.
struct Case {
  int pixels, shown;
  double spot;
};

constexpr Case kCases[] = {{5, 5, 0},     {1, 8, 0},     {64, 65, 0},   {7, 24, 0},
                           {130, 132, 0}, {40, 40, 0.4}, {40, 120, 1},  {64, 195, 0.25},
                           {3, 9, 2},     {1, 1, 5},     {50, 50, 0.1}, {33, 101, 5}};

double total(const LightShares& shares) {
  return std::accumulate(shares.weight.begin(), shares.weight.end(), 0.0);
}

// The mean over an output pixel of the spot's light from source pixel i, by Simpson's rule; the
// first and the last source pixel go on for ever.
double by_quadrature(const Case& c, int i, int out) {
  const auto below = [&](double t) { return std::erfc(-t / std::sqrt(2.0)) / 2; };
  const auto light = [&](double x) {
    const double from = i == 0 ? 0 : below((i - x) / c.spot);
    return (i == c.pixels - 1 ? 1 : below((i + 1 - x) / c.spot)) - from;
  };
  constexpr int kSteps = 400;
  const double left = static_cast<double>(out) * c.pixels / c.shown;
  const double length = static_cast<double>(c.pixels) / c.shown;
  double sum = 0;
  for (int k = 0; k <= kSteps; ++k)
    sum += (k == 0 || k == kSteps ? 1 : k % 2 == 1 ? 4 : 2) * light(left + length * k / kSteps);
  return sum / (3.0 * kSteps);
}

TEST(LightShares, SumToOneAndAreNeverNegative) {
  for (const Case& c : kCases) {
    const auto all = light_shares(c.pixels, c.shown, c.spot);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(c.shown));
    for (const LightShares& shares : all) {
      EXPECT_NEAR(total(shares), 1, 1e-12);
      for (const double weight : shares.weight) EXPECT_GE(weight, 0);
      EXPECT_GE(shares.first, 0);
      EXPECT_LE(shares.first + static_cast<int>(shares.weight.size()), c.pixels);
    }
  }
}

// In whole numbers: source pixel i is [i shown, (i + 1) shown), output pixel j [j pixels, ...).
TEST(LightShares, WithoutASpotAreTheCoveredParts) {
  for (const Case& c : kCases) {
    if (c.spot > 0) continue;
    const auto all = light_shares(c.pixels, c.shown, 0);
    for (int j = 0; j < c.shown; ++j) {
      const LightShares& shares = all[static_cast<std::size_t>(j)];
      for (int i = 0; i < c.pixels; ++i) {
        const int covered =
            std::min((i + 1) * c.shown, (j + 1) * c.pixels) - std::max(i * c.shown, j * c.pixels);
        const int at = i - shares.first;
        const bool has = at >= 0 && at < static_cast<int>(shares.weight.size());
        EXPECT_NEAR(has ? shares.weight[static_cast<std::size_t>(at)] : 0,
                    std::max(covered, 0) / static_cast<double>(c.pixels), 1e-12)
            << i << " in " << j;
      }
    }
  }
}

TEST(LightShares, AWholeMultipleIsExactlyThePixel) {
  for (const int multiple : {1, 2, 3, 7, 8}) {
    const auto all = light_shares(780, 780 * multiple, 0);
    for (std::size_t j = 0; j < all.size(); ++j) {
      ASSERT_EQ(all[j].weight, std::vector<double>{1});
      ASSERT_EQ(all[j].first, static_cast<int>(j) / multiple);
    }
  }
}

TEST(LightShares, OfASpotAreItsIntegrals) {
  for (const Case& c : kCases) {
    if (c.spot <= 0) continue;
    const auto all = light_shares(c.pixels, c.shown, c.spot);
    for (int j = 0; j < c.shown; ++j) {
      const LightShares& shares = all[static_cast<std::size_t>(j)];
      for (int i = 0; i < c.pixels; ++i) {
        const int at = i - shares.first;
        const bool has = at >= 0 && at < static_cast<int>(shares.weight.size());
        ASSERT_NEAR(has ? shares.weight[static_cast<std::size_t>(at)] : 0, by_quadrature(c, i, j),
                    1e-8)
            << i << " in " << j << " of " << c.pixels << " to " << c.shown << ", " << c.spot;
      }
    }
  }
}

// Nothing of the spot's light is lost or made: each source pixel away from the ends gives as much
// as it has.
TEST(LightShares, ConserveLight) {
  constexpr int kPixels = 60, kShown = 195;
  std::vector<double> given(kPixels);
  for (const LightShares& shares : light_shares(kPixels, kShown, 0.8))
    for (std::size_t k = 0; k < shares.weight.size(); ++k)
      given[static_cast<std::size_t>(shares.first) + k] += shares.weight[k] * kPixels / kShown;
  for (std::size_t i = 6; i + 6 < kPixels; ++i) EXPECT_NEAR(given[i], 1, 1e-8);
}

TEST(LightShares, RefuseWhatIsNoRow) {
  EXPECT_THROW(light_shares(0, 5, 0), std::invalid_argument);
  EXPECT_THROW(light_shares(5, 0, 0), std::invalid_argument);
  EXPECT_THROW(light_shares(5, 5, -1), std::invalid_argument);
  EXPECT_THROW(light_shares(5, 5, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace sir::eltek
