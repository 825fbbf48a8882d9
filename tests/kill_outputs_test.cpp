// kill -9 at moments spread over the run of each command: old or new, never a part.
#include <gtest/gtest.h>

#include "bench/kill_cases.h"
#include "tests/temp_folder.h"

namespace sir::bench {
namespace {

// tools/kill-outputs does it 200 times, with larger files.
TEST(KillOutputs, LeaveTheOldOrTheNewAndWhatIsLeftIsClearedUp) {
  constexpr int kKills = 12;
  constexpr std::uint64_t kSeed = 1989;
  const test::TempFolder folder;
  for (const KillCase& what : kill_cases(SIR_PROGRAM, folder.path(), {320, 240})) {
    const KillTally tally = KillTrial(SIR_PROGRAM, folder.path(), what).run(kKills, kSeed);
    EXPECT_EQ(tally.with_parts, 0) << what.name;
    EXPECT_EQ(tally.left_over, 0) << what.name;
    EXPECT_EQ(tally.old + tally.all_new + tally.mixed, kKills) << what.name;
    if (what.outputs.size() == 1) {
      EXPECT_EQ(tally.mixed, 0) << what.name;
    }
  }
}

// The referee itself: a program that writes in place is found out.
TEST(KillOutputs, APartIsSeen) {
  constexpr int kKills = 12;
  const test::TempFolder folder;
  const KillCase in_place{"in place",
                          {"-c", "printf old > x"},
                          {"-c", "printf half > x; sleep .3; printf whole > x"},
                          {"x"}};
  const KillTally tally = KillTrial("/bin/sh", folder.path(), in_place).run(kKills, 1);
  EXPECT_GT(tally.with_parts, 0);
  EXPECT_EQ(tally.old + tally.all_new + tally.mixed + tally.with_parts, kKills);
}

}  // namespace
}  // namespace sir::bench
