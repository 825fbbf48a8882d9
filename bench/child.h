// Starting a program and learning what it cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sir::bench {

/// CPU seconds, user's and system's, of this process so far.
double own_cpu_seconds();

/// Runs a program to its end: words[0] is looked for in PATH, standard output goes into the
/// file `out`, standard error is thrown away. CPU seconds, user's and system's, of it and the
/// programs that it waited for; nothing where it cannot be started or its exit code is not 0.
std::optional<double> child_cpu_seconds(const std::vector<std::string>& words,
                                        const std::string& out = "/dev/null");

}  // namespace sir::bench
