// The mask: every rank once, and little energy at low frequencies.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "quant/blue_noise.h"

namespace sir::quant {
namespace {

constexpr int kSide = static_cast<int>(BlueNoise::kSide);
constexpr double kCells = BlueNoise::kRanks;

TEST(BlueNoise, HoldsEveryRankOnce) {
  std::vector<int> times(BlueNoise::kRanks);
  for (std::size_t row = 0; row < BlueNoise::kSide; ++row)
    for (std::size_t column = 0; column < BlueNoise::kSide; ++column)
      ++times.at(BlueNoise::mask().rank(column, row));
  EXPECT_EQ(times, std::vector<int>(BlueNoise::kRanks, 1));
}

TEST(BlueNoise, TilesThePlane) {
  const BlueNoise& mask = BlueNoise::mask();
  for (std::size_t i = 0; i < 1000; ++i)
    EXPECT_EQ(mask.rank(i, 3 * i), mask.rank(i % BlueNoise::kSide, 3 * i % BlueNoise::kSide));
  EXPECT_NE(mask.rank(1, 2), mask.rank(2, 1));
}

/// The mean power of the pattern of all ranks below `dots`, over frequencies of `from` to `to`
/// periods across the mask, as a share of what as many dots at random would have.
double power(std::size_t dots, int from, int to) {
  double sum = 0;
  int frequencies = 0;
  for (int v = -to; v <= to; ++v)
    for (int u = 0; u <= to; ++u) {
      const double radius = std::hypot(u, v);
      if (radius < from || radius > to) continue;
      std::complex<double> amplitude = 0;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          if (BlueNoise::mask().rank(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) <
              dots)
            amplitude += std::polar(1.0, 2 * std::numbers::pi * (u * x + v * y) / kSide);
      sum += std::norm(amplitude);
      ++frequencies;
    }
  const double share = static_cast<double>(dots) / kCells;
  return sum / frequencies / (kCells * share * (1 - share));
}

// A tenth of the pixels are 3.2 apart on a lattice: 20 periods across the mask, and more where
// there are more dots. 8 periods are low for all shares here.
TEST(BlueNoise, HasLittleEnergyAtLowFrequencies) {
  for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
    const auto dots = static_cast<std::size_t>(share * kCells);
    const double low = power(dots, 1, 8), high = power(dots, 20, 28);
    EXPECT_LT(low, 0.1) << share << " high " << high;
    EXPECT_GT(high, 0.5) << share;
  }
}

// Any two neighbours in rank lie apart: dots that come next to each other in rank fill voids.
TEST(BlueNoise, SpreadsTheFirstDots) {
  constexpr std::size_t kDots = 256;  // one in 16: on a lattice they would be 4 apart
  std::vector<std::pair<int, int>> dots;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (BlueNoise::mask().rank(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) < kDots)
        dots.emplace_back(x, y);
  double closest = kSide;
  for (std::size_t i = 0; i < dots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto apart = [](int a, int b) {
        const int d = std::abs(a - b);
        return std::min(d, kSide - d);
      };
      closest = std::min(closest, std::hypot(apart(dots[i].first, dots[j].first),
                                             apart(dots[i].second, dots[j].second)));
    }
  EXPECT_GE(closest, 2);
}

}  // namespace
}  // namespace sir::quant
