// How many random cases a test tries.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace sir::test {

/// `usual`, or the share of it that SIR_TEST_SHARE in the environment asks for, at least two: under
/// the sanitizers a case takes many times as long.
inline std::uint64_t cases(std::uint64_t usual) {
  const char* const text = std::getenv("SIR_TEST_SHARE");
  if (text == nullptr) return usual;
  const double share = std::clamp(std::strtod(text, nullptr), 0.0, 1.0);
  return std::max(static_cast<std::uint64_t>(share * static_cast<double>(usual)),
                  std::min<std::uint64_t>(usual, 2));
}

}  // namespace sir::test
