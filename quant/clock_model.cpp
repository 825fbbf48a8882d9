#include "quant/clock_model.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace sir::quant {
namespace {

using Column = std::vector<double>;

double dot(const Column& a, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void subtract(Column& from, double times, const Column& what) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= times * what[i];
}

/// Least squares on some of three columns, by orthogonalising them in turn, twice each.
struct Solution {
  bool valid = false;  ///< the columns are independent and no constant is negative
  std::array<double, 3> x{};
  double error = 0;
};

Solution solve(const std::array<Column, 3>& columns, unsigned set, const Column& y) {
  constexpr double kDependent = 1e-12;  // of a column's length left over by the others
  std::vector<std::size_t> members;
  for (std::size_t c = 0; c < 3; ++c)
    if (set >> c & 1u) members.push_back(c);
  Solution solution;
  std::vector<Column> q;
  std::array<std::array<double, 3>, 3> upper{};
  Column rest = y;
  std::array<double, 3> along{};
  for (std::size_t k = 0; k < members.size(); ++k) {
    Column column = columns[members[k]];
    const double length = std::sqrt(dot(column, column));
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t j = 0; j < k; ++j) {
        const double part = dot(q[j], column);
        upper[j][k] += part;
        subtract(column, part, q[j]);
      }
    upper[k][k] = std::sqrt(dot(column, column));
    if (upper[k][k] <= kDependent * length) return solution;
    for (double& value : column) value /= upper[k][k];
    along[k] = dot(column, rest);
    subtract(rest, along[k], column);
    q.push_back(std::move(column));
  }
  for (std::size_t k = members.size(); k-- > 0;) {
    double x = along[k];
    for (std::size_t j = k + 1; j < members.size(); ++j) x -= upper[k][j] * solution.x[members[j]];
    solution.x[members[k]] = x / upper[k][k];
  }
  solution.error = dot(rest, rest);
  solution.valid =
      std::all_of(solution.x.begin(), solution.x.end(), [](double x) { return x >= 0; });
  return solution;
}

double value_of(const WorkRow& row, const std::array<double, 3>& x) {
  return row[0] * x[0] + row[1] * x[1] + row[2] * x[2];
}

std::vector<std::string> images_of(std::span<const ClockSample> samples) {
  std::vector<std::string> images;
  for (const ClockSample& sample : samples)
    if (std::find(images.begin(), images.end(), sample.image) == images.end())
      images.push_back(sample.image);
  return images;
}

bool is_calice(const std::string& image) {
  constexpr std::string_view kName = "calice";
  return std::equal(image.begin(), image.end(), kName.begin(), kName.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

/// Squared seconds by which the image is missed, the constants taken from the other images.
double missed_by(const std::string& image, std::span<const ClockSample> samples,
                 std::span<const WorkRow> rows) {
  std::vector<WorkRow> others;
  Column times;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].image != image) {
      others.push_back(rows[i]);
      times.push_back(samples[i].measured_seconds);
    }
  const auto constants = least_squares_nonnegative(others, times);
  double squares = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].image == image)
      squares += std::pow(value_of(rows[i], constants) - samples[i].measured_seconds, 2);
  return squares;
}

ClockFit fit(std::span<const ClockSample> samples, std::span<const WorkRow> rows) {
  const auto images = images_of(samples);
  if (images.size() < 2) throw std::invalid_argument("a clock needs two images at least");
  Column times;
  double mean = 0;
  for (const ClockSample& sample : samples) {
    times.push_back(sample.measured_seconds);
    mean += sample.measured_seconds / static_cast<double>(samples.size());
  }
  if (std::equal(times.begin() + 1, times.end(), times.begin()))
    throw std::invalid_argument("all times are the same: nothing to explain");
  ClockFit result;
  result.seconds_per = least_squares_nonnegative(rows, times);
  double missed = 0, spread = 0, missed_apart = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.predicted.push_back(value_of(rows[i], result.seconds_per));
    missed += std::pow(result.predicted[i] - times[i], 2);
    spread += std::pow(times[i] - mean, 2);
  }
  for (const std::string& image : images) missed_apart += missed_by(image, samples, rows);
  result.r2 = 1 - missed / spread;
  result.leave_one_image_out = std::sqrt(missed_apart / static_cast<double>(samples.size()));
  const auto faster = faster_in_rgb(samples, result.predicted);
  result.calice_rgb_faster = std::any_of(faster.begin(), faster.end(), is_calice);
  return result;
}

WorkRow row_of(const ThesisWork& work, std::uint64_t last) {
  return {static_cast<double>(work.pixels_read), static_cast<double>(work.conversions),
          static_cast<double>(last)};
}

}  // namespace

std::array<double, 3> least_squares_nonnegative(std::span<const WorkRow> rows,
                                                std::span<const double> y) {
  if (rows.size() != y.size()) throw std::invalid_argument("rows and times differ in number");
  std::array<Column, 3> columns;
  for (const WorkRow& row : rows)
    for (std::size_t c = 0; c < 3; ++c) columns[c].push_back(row[c]);
  // The best point of the cone of the columns lies within the cone of some independent ones,
  // all with positive constants: there it is their unconstrained solution. So no set is missed
  // by leaving out the dependent ones. The small sets come first and win a tie.
  Solution best;
  for (const unsigned set : {0u, 1u, 2u, 4u, 3u, 5u, 6u, 7u}) {
    const Solution candidate = solve(columns, set, {y.begin(), y.end()});
    if (candidate.valid && (!best.valid || candidate.error < best.error)) best = candidate;
  }
  return best.x;
}

ClockFit fit_clock(std::span<const ClockSample> samples) {
  std::vector<WorkRow> rows;
  for (const ClockSample& sample : samples)
    rows.push_back(row_of(sample.work, sample.work.cells_visited));
  return fit(samples, rows);
}

ClockFit fit_counts(std::span<const ClockSample> samples) {
  std::vector<WorkRow> rows;
  for (const ClockSample& sample : samples) rows.push_back(row_of(sample.work, sample.colours));
  return fit(samples, rows);
}

std::vector<std::string> faster_in_rgb(std::span<const ClockSample> samples,
                                       std::span<const double> seconds) {
  if (samples.size() != seconds.size()) throw std::invalid_argument("samples and times differ");
  std::vector<std::string> faster;
  for (const std::string& image : images_of(samples)) {
    double rgb = std::numeric_limits<double>::infinity(), hsv = -rgb;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].image == image) (samples[i].space == Space::rgb ? rgb : hsv) = seconds[i];
    if (rgb < hsv) faster.push_back(image);
  }
  return faster;
}

}  // namespace sir::quant
