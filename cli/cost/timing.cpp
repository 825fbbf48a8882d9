#include "cli/cost/timing.h"

#include <algorithm>
#include <cmath>

namespace sir::cli {

Spread spread_of(std::span<const double> values) {
  if (values.empty()) return {};
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
  };
  return {at(0.5), at(0.25), at(0.75), sorted.size()};
}

Spread ratio_of(std::span<const double> times, std::span<const double> base) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(times.size(), base.size()); ++i)
    ratios.push_back(times[i] / base[i]);
  return spread_of(ratios);
}

bool Rounds::operator()(const Run& run, const RunsOf& runs_of) const {
  for (std::size_t round = 0; round < repeats_; ++round)
    for (std::size_t i = 0; i < rows_; ++i) {
      const std::size_t row = (round + i) % rows_;
      if (round > 0 && runs_of && round >= runs_of(row)) continue;
      if (!run(row)) return false;
    }
  return true;
}

std::size_t affordable_runs(double ms, double base, std::size_t repeats) {
  constexpr double kDear = 10;
  if (ms <= kDear * base) return repeats;
  const double runs = std::floor(kDear * base * static_cast<double>(repeats) / ms);
  return std::min(repeats, std::max<std::size_t>(2, static_cast<std::size_t>(runs)));
}

}  // namespace sir::cli
