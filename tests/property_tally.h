// How many rays a property test casts, and what came of them.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/cases.h"
#include "tests/property_scene.h"

namespace sir::test {

/// Rays of the whole suite, SIR_PROPERTY_RAYS in the environment; 10^7 else, or a share of them
/// (cases.h). The shares add up to somewhat more, the rest being refractions without a solid.
inline std::uint64_t rays_of_suite() {
  const char* const text = std::getenv("SIR_PROPERTY_RAYS");
  return text == nullptr ? cases(10'000'000) : std::strtoull(text, nullptr, 10);
}

/// Counts rays up to this test's share of the suite's, and prints the sums at
/// its end; during it, ten times, where there are more than the usual number.
class Tally {
 public:
  Tally(std::string property, double percent)
      : property_(std::move(property)),
        wanted_(static_cast<std::uint64_t>(static_cast<double>(rays_of_suite()) * percent / 100)),
        talkative_(rays_of_suite() > 10'000'000) {}
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  ~Tally() { print("done"); }

  bool wants_more() const { return rays < wanted_; }

  /// To be called now and then.
  void progress() {
    if (!talkative_ || rays < wanted_ / 10 * (tenths_ + 1)) return;
    tenths_ = rays * 10 / wanted_;
    print("so far");
  }

  /// Counts a failure; the first few are told in full.
  void fail(std::uint64_t seed, Regime regime, const TestRay& ray, const std::string& what) {
    if (++failures_ <= 3)
      ADD_FAILURE() << property_ << ": " << what << "\n  regime " << name_of(regime) << ", seed "
                    << seed << ", ray " << describe(ray);
  }

  std::uint64_t rays = 0;       ///< cast by the program, with their hits looked at
  std::uint64_t hits = 0;       ///< found along them
  std::uint64_t decided = 0;    ///< comparisons with an exact answer
  std::uint64_t undecided = 0;  ///< such comparisons given up within roundings of a surface

 private:
  void print(const char* when) const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::printf(
        "[ property ] %s, %s: rays %llu, hits %llu, decided %llu, undecided %llu, "
        "failures %llu; %.1f s\n",
        property_.c_str(), when, as_printed(rays), as_printed(hits), as_printed(decided),
        as_printed(undecided), as_printed(failures_), seconds);
    std::fflush(stdout);
  }
  static unsigned long long as_printed(std::uint64_t n) { return n; }

  std::string property_;
  std::uint64_t wanted_, failures_ = 0, tenths_ = 0;
  bool talkative_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A property that is tested in each regime by itself, so that the tests can
/// run side by side.
class InRegime : public testing::TestWithParam<Regime> {};

#define SIR_IN_EVERY_REGIME(suite)                                               \
  INSTANTIATE_TEST_SUITE_P(Every, suite, testing::ValuesIn(sir::test::kRegimes), \
                           [](const auto& made) { return sir::test::name_of(made.param); })

}  // namespace sir::test
