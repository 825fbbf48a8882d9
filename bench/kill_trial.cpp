#include "bench/kill_trial.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <thread>

#include "tracer/stale_temporaries.h"

namespace sir::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

pid_t start(const std::string& program, const fs::path& folder,
            const std::vector<std::string>& words) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process");
  if (process == 0) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO}) ::dup2(nowhere, stream);
    if (::chdir(folder.c_str()) == 0) ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

KillTrial::KillTrial(std::string program, fs::path folder, KillCase what)
    : program_(std::move(program)), folder_(std::move(folder)), what_(std::move(what)) {
  constexpr int kRuns = 5;
  run_whole(what_.before);
  old_ = contents();
  std::vector<double> times;
  for (int i = 0; i < kRuns; ++i) {
    restore();
    times.push_back(run_whole(what_.killed));
  }
  std::sort(times.begin(), times.end());
  seconds_ = times[kRuns / 2];
  new_ = contents();
  for (const std::string& name : what_.outputs)
    if (!old_.contains(name) || !new_.contains(name) || old_[name] == new_[name])
      throw std::runtime_error(name + " does not tell old from new");
}

KillTally KillTrial::run(int kills, std::uint64_t seed) {
  KillTally tally;
  tally.seconds = seconds_;
  std::mt19937_64 random(seed);
  for (int i = 0; i < kills; ++i) {
    restore();
    const double within = std::uniform_real_distribution<double>(0, 1)(random);
    if (!kill_after((i + within) / kills * seconds_)) ++tally.too_late;
    ++tally.kills;
    judge(tally);
  }
  run_whole(what_.killed);
  tally.left_over = static_cast<int>(temporaries().size());
  return tally;
}

// Seconds.
double KillTrial::run_whole(const std::vector<std::string>& words) const {
  const auto begin = Clock::now();
  if (wait_for(start(program_, folder_, words)) != 0)
    throw std::runtime_error(what_.name + ": a run that nobody kills fails");
  return Seconds(Clock::now() - begin).count();
}

// False where the run was over before.
bool KillTrial::kill_after(double seconds) const {
  const pid_t process = start(program_, folder_, what_.killed);
  std::this_thread::sleep_for(Seconds(seconds));
  ::kill(process, SIGKILL);
  return WIFSIGNALED(wait_for(process));
}

KillTrial::Contents KillTrial::contents() const {
  Contents all;
  for (const std::string& name : what_.outputs)
    if (fs::exists(folder_ / name)) all[name] = read(folder_ / name);
  return all;
}

// The temporary files stay, as they do where a person starts a command again.
void KillTrial::restore() const {
  for (const auto& [name, bytes] : old_)
    std::ofstream(folder_ / name, std::ios::binary) << bytes << std::flush;
}

std::vector<fs::path> KillTrial::temporaries() const {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder_))
    for (const std::string& name : what_.outputs)
      if (is_temporary_of(entry.path().filename().native(), fs::path(name).filename().native()))
        found.push_back(entry.path());
  return found;
}

void KillTrial::judge(KillTally& tally) {
  const Contents found = contents();
  int old_ones = 0, new_ones = 0;
  for (const auto& [name, bytes] : found) {
    old_ones += bytes == old_.at(name);
    new_ones += bytes == new_.at(name);
  }
  const int all = static_cast<int>(what_.outputs.size());
  if (old_ones + new_ones != all) ++tally.with_parts;
  else if (old_ones == all) ++tally.old;
  else if (new_ones == all) ++tally.all_new;
  else ++tally.mixed;
  int fresh = 0;
  for (const auto& path : temporaries()) fresh += seen_.insert(path).second;
  tally.while_writing += fresh > 0;
  tally.before_output += fresh == 0 && old_ones == all;
  tally.temporaries += fresh;
}

std::string kill_table_head() {
  return "| command | ms | kills | before any output | while writing | over | old | new | mixed | "
         "parts | temporaries left | not cleared up |\n"
         "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string kill_table_row(const std::string& name, const KillTally& tally) {
  std::string row = "| " + name + " |";
  for (const int value :
       {static_cast<int>(std::lround(tally.seconds * 1e3)), tally.kills, tally.before_output,
        tally.while_writing, tally.too_late, tally.old, tally.all_new, tally.mixed,
        tally.with_parts, tally.temporaries, tally.left_over})
    row += " " + std::to_string(value) + " |";
  return row + "\n";
}

}  // namespace sir::bench
