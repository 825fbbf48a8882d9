// Starting a program and learning what it cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sir::bench {

/// CPU seconds, user's and system's, of this process so far.
double own_cpu_seconds();

/// What a program and those that it waited for have used.
struct ChildUse {
  double cpu_seconds = 0;   ///< user's and system's
  long peak_kilobytes = 0;  ///< of memory, of the largest; never less than what this process has
                            ///< when it starts the other: Linux counts from before the exec
};

/// Runs a program to its end: words[0] is looked for in PATH, standard output goes into the
/// file `out`, standard error is thrown away. Nothing where it cannot be started or its exit
/// code is not 0.
std::optional<ChildUse> child_use(const std::vector<std::string>& words,
                                  const std::string& out = "/dev/null");

/// Its CPU seconds alone.
std::optional<double> child_cpu_seconds(const std::vector<std::string>& words,
                                        const std::string& out = "/dev/null");

}  // namespace sir::bench
