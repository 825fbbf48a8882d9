// The command line: from words to one of the commands.
#pragma once

namespace sir::cli {

/// Parses the command line and runs the command; --help and --version go to
/// standard output, what is wrong with the usage to standard error with
/// kUsage. Returns the exit code; throws what the commands throw.
int run(int argc, char** argv);

}  // namespace sir::cli
