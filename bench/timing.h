// Timing for the benchmark programs: medians, never single runs.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace sir::bench {

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Wall time of one call.
template <typename Work>
double milliseconds(Work work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace sir::bench
