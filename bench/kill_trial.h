// What kill -9 leaves of a command's outputs, at moments spread over its run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sir::bench {

/// Two commands that write the same files with other bytes in each: the one that made the old
/// files, and the one that is killed. Words after the program's name; the working directory is the
/// trial's folder.
struct KillCase {
  std::string name;
  std::vector<std::string> before, killed;
  std::vector<std::string> outputs;  ///< relative to the trial's folder
};

/// What was found after the kills; each is in one of old, all_new, mixed and with_parts.
struct KillTally {
  int kills = 0;
  int before_output = 0;  ///< of those, left all old and no temporary files
  int too_late = 0;       ///< of those, came when the run was over
  int while_writing = 0;  ///< left temporary files: some output was written, not all had names
  int old = 0;            ///< all outputs are the old ones
  int all_new = 0;
  int mixed = 0;        ///< whole files, some old and some new
  int with_parts = 0;   ///< a file that is neither, or none: must not be
  int temporaries = 0;  ///< that were left, in all
  int left_over = 0;    ///< of those, that the next whole run does not remove: must not be
  double seconds = 0;   ///< of a whole run, median
};

/// One line of a table in Markdown, under kill_table_head().
std::string kill_table_row(const std::string& name, const KillTally& tally);
std::string kill_table_head();

class KillTrial {
 public:
  /// Throws std::runtime_error where a command fails or writes the same bytes as before.
  KillTrial(std::string program, std::filesystem::path folder, KillCase what);

  /// Kills as many runs, one within each of as many equal parts of a whole run's time, at a moment
  /// within it that `seed` decides.
  KillTally run(int kills, std::uint64_t seed);

 private:
  using Contents = std::map<std::string, std::string>;
  double run_whole(const std::vector<std::string>& words) const;
  bool kill_after(double seconds) const;
  Contents contents() const;
  void restore() const;
  std::vector<std::filesystem::path> temporaries() const;
  void judge(KillTally& tally);

  std::string program_;
  std::filesystem::path folder_;
  KillCase what_;
  Contents old_, new_;
  double seconds_ = 0;
  std::set<std::filesystem::path> seen_;  // temporary files, in all kills
};

}  // namespace sir::bench
