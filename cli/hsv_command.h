// `sir hsv`: the thesis's conversion and binning, one colour a line (thesis 3.4.2, 3.4.3).
#pragma once

#include <cstddef>
#include <cstdio>

#include "cli/session.h"

namespace sir::cli {

/// Reads byte triples `r g b` from `in`, one a line, and prints a JSON line
/// each: {"h":degrees,"s":..,"v":..,"bin":[h,s,v]}, or "grey":v in place of
/// the bin; 17 significant digits. Blank lines are passed over. A bad line
/// (also one longer than kLongestLine bytes) gives {"error":".."} in its
/// place, and kFailed at the end. Nothing may have been read from `in`
/// before. Throws FileError where reading or printing fails.
int run_hsv(std::FILE* in, const Session& session);

inline constexpr std::size_t kLongestLine = std::size_t{1} << 16;

}  // namespace sir::cli
