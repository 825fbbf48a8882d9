// The tables of `quantizers`, and the same as JSON.
#pragma once

#include <string>
#include <vector>

#include "bench/quantizers_results.h"

namespace sir::bench {

/// Prints a picture's rows, its floor above them.
void print_picture(const Picture& picture, bool dithered);

/// Prints each contender's means over the pictures that are not trivial, and their floor's.
void print_means(const Pictures& pictures, const std::vector<std::string>& contenders,
                 bool dithered);

/// Prints the targets beside what was measured; the number of those that were missed.
int print_targets(const std::vector<Target>& targets);

/// Writes all of it. Throws FileError.
void write_json(const std::string& path, const Pictures& pictures,
                const std::vector<Target>& targets);

}  // namespace sir::bench
