// Waiting for what other threads do.
#pragma once

#include <chrono>
#include <thread>

namespace sir::test {

/// Whether the condition comes true; it is given far longer than it takes, for machines with
/// other things to do.
template <typename Condition>
bool eventually(Condition condition) {
  constexpr std::chrono::seconds kLimit{30};
  constexpr std::chrono::milliseconds kPause{1};
  const auto end = std::chrono::steady_clock::now() + kLimit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

}  // namespace sir::test
