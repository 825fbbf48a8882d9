// Every subcommand that writes files, with all that it can write, small.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/cli_fixture.h"

namespace sir::test {

/// A command and what it writes into the folder `o`.
struct WritingCommand {
  std::string name;
  std::vector<std::string> words;
  std::vector<std::string> outputs;
  bool together = true;       ///< its outputs change together or not at all
  bool same_bytes = true;     ///< every run writes the same: no times are in it
  bool tells_nothing = true;  ///< on standard output
};

/// The scene `s` with its picture, LUT and trace, and an empty folder `o`.
class WritingTest : public CliTest {
 protected:
  WritingTest();

  /// Writes "old" into each output, and nothing else into `o`.
  void make_old(const WritingCommand& command) const;

  /// Its outputs as they are, by name; a missing one is not there.
  std::map<std::string, std::string> found(const WritingCommand& command) const;

  /// What the command writes, where it is not hindered.
  std::map<std::string, std::string> made_by(const WritingCommand& command) const;

  /// That the run failed as it should: exit code 1, and last a line that names an output and holds
  /// `reason`.
  static void expect_failed(const WritingCommand& command, const Ended& ended,
                            const std::string& reason);

  /// That after a failure each output is whole, the old one or what `made` has, all of them old
  /// where they belong together; and that `o` holds nothing else but `filler`.
  void expect_nothing_lost(const WritingCommand& command,
                           const std::map<std::string, std::string>& made) const;
};

const std::vector<WritingCommand>& writing_commands();

}  // namespace sir::test
