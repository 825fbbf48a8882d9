// Non-negative least squares against what makes a solution the best one, and the clock's fit.
#include "quant/clock_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace sir::quant {
namespace {

using Constants = std::array<double, 3>;

double error_of(const std::vector<WorkRow>& rows, const std::vector<double>& y, Constants x) {
  double sum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    sum += std::pow(rows[i][0] * x[0] + rows[i][1] * x[1] + rows[i][2] * x[2] - y[i], 2);
  return sum;
}

TEST(NonNegativeLeastSquares, FindsKnownSolutions) {
  const std::vector<WorkRow> rows{{1, 0, 0}, {0, 2, 0}, {0, 0, 4}, {1, 1, 1}};
  const Constants exact = least_squares_nonnegative(rows, std::vector<double>{3, 10, 8, 10});
  EXPECT_NEAR(exact[0], 3, 1e-12);
  EXPECT_NEAR(exact[1], 5, 1e-12);
  EXPECT_NEAR(exact[2], 2, 1e-12);
  // Without the limit x = (-1, 2, 0); with it the best multiple of the second column remains:
  // 5 y - 8 = 0.
  const std::vector<WorkRow> slanted{{1, 1, 0}, {1, 2, 0}};
  const Constants clipped = least_squares_nonnegative(slanted, std::vector<double>{1, 3});
  EXPECT_EQ(clipped[0], 0);
  EXPECT_NEAR(clipped[1], 1.4, 1e-12);
  EXPECT_EQ(clipped[2], 0);
  EXPECT_EQ(least_squares_nonnegative(slanted, std::vector<double>{-1, -3}), (Constants{0, 0, 0}));
}

TEST(NonNegativeLeastSquares, EqualColumnsNeedOneConstant) {
  const std::vector<WorkRow> rows{{2, 2, 1}, {2, 2, 2}, {2, 2, 4}};
  const Constants x = least_squares_nonnegative(rows, std::vector<double>{7, 8, 10});  // 6 + third
  EXPECT_NEAR(x[0] + x[1], 3, 1e-12);
  EXPECT_EQ(x[0] * x[1], 0);
  EXPECT_NEAR(x[2], 1, 1e-12);
}

// A convex problem's solution is known by its gradient: zero along the constants that are
// positive, not negative along the others (Karush, Kuhn and Tucker).
TEST(NonNegativeLeastSquares, NoStepImprovesRandomProblems) {
  std::mt19937 random(1989);
  std::uniform_real_distribution<double> number(-1, 1);
  int zeros = 0, positives = 0;
  for (int problem = 0; problem < 2000; ++problem) {
    std::vector<WorkRow> rows(3 + random() % 8);
    std::vector<double> y;
    const double scale = std::pow(10, 6 * number(random));
    for (WorkRow& row : rows) {
      row = {number(random), number(random), scale * number(random)};
      if (problem % 5 == 0) row[1] = row[0];  // dependent columns
      y.push_back(number(random));
    }
    const Constants x = least_squares_nonnegative(rows, y);
    for (std::size_t c = 0; c < 3; ++c) {
      double slope = 0, length = 0;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const WorkRow& row = rows[i];
        slope += row[c] * (row[0] * x[0] + row[1] * x[1] + row[2] * x[2] - y[i]);
        length += row[c] * row[c];
      }
      slope /= std::sqrt(length);
      ASSERT_GE(x[c], 0);
      ASSERT_GE(slope, -1e-9) << "problem " << problem << ", constant " << c;
      if (x[c] > 0) {
        ASSERT_LE(slope, 1e-9) << "problem " << problem << ", constant " << c;
      }
      ++(x[c] > 0 ? positives : zeros);
    }
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(positives, 1000);
}

TEST(NonNegativeLeastSquares, BeatsEveryPointOfAFineLattice) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  for (int problem = 0; problem < 20; ++problem) {
    std::vector<WorkRow> rows(10);
    std::vector<double> y;
    for (WorkRow& row : rows) {
      row = {1, number(random), number(random)};
      y.push_back(2 * number(random));
    }
    const double best = error_of(rows, y, least_squares_nonnegative(rows, y));
    double best_of_lattice = 1e9;
    for (int a = 0; a <= 60; ++a)
      for (int b = 0; b <= 60; ++b)
        for (int c = 0; c <= 60; ++c)
          best_of_lattice =
              std::min(best_of_lattice, error_of(rows, y, {a / 20., b / 20., c / 20.}));
    EXPECT_LE(best, best_of_lattice + 1e-12);
    EXPECT_GE(best, best_of_lattice - 0.02);  // the lattice is fine enough to come near
  }
}

TEST(NonNegativeLeastSquares, RefusesUnequalLengths) {
  EXPECT_THROW(least_squares_nonnegative(std::vector<WorkRow>(2), std::vector<double>(3)),
               std::invalid_argument);
}

ClockSample sample(const char* image, Space space, std::uint64_t cells, std::size_t colours,
                   double seconds) {
  return {image, space, {1000, space == Space::hsv ? 1000u : 0u, cells}, colours, seconds};
}

/// Times of 20 ms a pixel, 10 ms a conversion, 50 ms a cell; colours that say nothing.
std::vector<ClockSample> made_up() {
  return {sample("Calice", Space::rgb, 100, 9, 25),  sample("Calice", Space::hsv, 50, 900, 32.5),
          sample("lcg", Space::rgb, 900, 10, 65),    sample("lcg", Space::hsv, 60, 800, 33),
          sample("whitted", Space::rgb, 500, 8, 45), sample("whitted", Space::hsv, 80, 950, 34)};
}

TEST(ClockFit, FindsTheConstantsThatMadeTheTimes) {
  const auto samples = made_up();
  const ClockFit fit = fit_clock(samples);
  EXPECT_NEAR(fit.seconds_per[0], 0.02, 1e-12);
  EXPECT_NEAR(fit.seconds_per[1], 0.01, 1e-12);
  EXPECT_NEAR(fit.seconds_per[2], 0.05, 1e-12);
  EXPECT_NEAR(fit.r2, 1, 1e-12);
  EXPECT_NEAR(fit.leave_one_image_out, 0, 1e-9);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_NEAR(fit.predicted[i], samples[i].measured_seconds, 1e-9);
  EXPECT_TRUE(fit.calice_rgb_faster);
  EXPECT_EQ(faster_in_rgb(samples, fit.predicted), std::vector<std::string>{"Calice"});
}

TEST(ClockFit, CountsThatSayNothingExplainTheSpaceOnly) {
  const auto samples = made_up();
  const ClockFit fit = fit_counts(samples);
  EXPECT_LT(fit.r2, 0.5);
  EXPECT_GT(fit.leave_one_image_out, 5);
}

TEST(ClockFit, LeavesBothTimesOfAnImageOut) {
  // One constant, seconds a pixel: the mean of the other image's times.
  const std::vector<ClockSample> samples{{"a", Space::rgb, {1, 0, 0}, 0, 10},
                                         {"a", Space::rgb, {1, 0, 0}, 0, 20},
                                         {"b", Space::rgb, {1, 0, 0}, 0, 40},
                                         {"b", Space::rgb, {1, 0, 0}, 0, 50}};
  const ClockFit fit = fit_clock(samples);
  EXPECT_NEAR(fit.seconds_per[0], 30, 1e-12);
  EXPECT_NEAR(fit.r2, 0, 1e-12);
  // a from 45: -35, -25; b from 15: 25, 35.
  EXPECT_NEAR(fit.leave_one_image_out, std::sqrt(925), 1e-9);
  EXPECT_FALSE(fit.calice_rgb_faster);
}

TEST(ClockFit, SaysWhichImagesAreFasterInRgb) {
  auto samples = made_up();
  EXPECT_EQ(faster_in_rgb(samples, std::vector<double>{2, 1, 1, 2, 1, 1}),
            std::vector<std::string>{"lcg"});
  samples[0].work.cells_visited = 900;  // the goblet's boxes as large as the rest's
  samples[0].measured_seconds = 65;
  EXPECT_FALSE(fit_clock(samples).calice_rgb_faster);
}

TEST(ClockFit, RefusesWhatCannotBeFitted) {
  auto samples = made_up();
  EXPECT_THROW(fit_clock(std::span(samples).first(2)), std::invalid_argument);
  EXPECT_THROW(fit_clock({}), std::invalid_argument);
  for (auto& one : samples) one.measured_seconds = 3;
  EXPECT_THROW(fit_counts(samples), std::invalid_argument);
  EXPECT_THROW(faster_in_rgb(samples, std::vector<double>(2)), std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
