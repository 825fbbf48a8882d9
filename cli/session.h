// What every subcommand shares: exit codes, standard output, messages.
#pragma once

#include <string_view>

namespace sir::cli {

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,     ///< bad input or failed work
  kUsage = 2,      ///< wrong usage
  kThreshold = 3,  ///< a threshold that was asked for is not met
  kInterrupted = 130
};

/// Global options: -q silences notes and progress, -v adds detail.
struct Session {
  bool quiet = false;
  bool verbose = false;
};

/// Takes the numbers of standard streams that are closed from the start, so that no output file
/// gets one and is written into by mistake. Reading or writing them stays an error.
void reserve_standard_streams();

/// Writes a result to standard output. Throws FileError when it cannot be
/// written (full disk, closed pipe).
void print(std::string_view text);

/// Flushes standard output; the same errors. Called once at the end by main.
void flush_output();

/// A message for the person, on standard error; nothing with -q.
void note(const Session& session, std::string_view text);

/// A detail that is worth saying only with -v.
void detail(const Session& session, std::string_view text);

}  // namespace sir::cli
