// kill_outputs SIR [N]: kill -9 at N moments (200) of each of render, lut, show and model, and what
// it leaves, as a table. Exit code 1 where a file is neither the old nor the new.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "bench/kill_cases.h"
#include "tests/temp_folder.h"

namespace {

constexpr int kKills = 200;
constexpr std::uint64_t kSeed = 1989;
// Larger than the display, so that files take time to write.
constexpr sir::ImageSize kSize{1600, 1200};

int run(const std::string& program, int kills, const std::filesystem::path& folder) {
  bool whole = true;
  std::fputs(sir::bench::kill_table_head().c_str(), stdout);
  for (const auto& what : sir::bench::kill_cases(program, folder, kSize)) {
    const auto tally = sir::bench::KillTrial(program, folder, what).run(kills, kSeed);
    std::fputs(sir::bench::kill_table_row(what.name, tally).c_str(), stdout);
    std::fflush(stdout);
    whole = whole && tally.with_parts == 0 && tally.left_over == 0;
  }
  return whole ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const int kills = argc > 2 ? std::atoi(argv[2]) : kKills;
  if (argc < 2 || argc > 3 || kills < 1) {
    std::fputs("usage: kill_outputs SIR [N]\n", stderr);
    return 2;
  }
  const sir::test::TempFolder scratch;
  return run(std::filesystem::absolute(argv[1]), kills, scratch.path());
} catch (const std::exception& failure) {
  std::fprintf(stderr, "kill_outputs: %s\n", failure.what());
  return 1;
}
