// Timing for the benchmark programs: medians, never single runs.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

namespace sir::bench {

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// How many rounds a program makes: `usual`, or fewer where SIR_BENCH_ROUNDS asks for them, to see
/// that the program runs.
inline int rounds(int usual) {
  const char* const most = std::getenv("SIR_BENCH_ROUNDS");
  return most == nullptr ? usual : std::clamp(std::atoi(most), 1, usual);
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
