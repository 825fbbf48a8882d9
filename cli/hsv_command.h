// `sir hsv`: the thesis's conversion and binning, one colour a line (thesis 3.4.2, 3.4.3).
#pragma once

#include "cli/session.h"

namespace sir::cli {

/// Reads byte triples `r g b` from the descriptor, one a line, and prints a
/// JSON line each: {"h":degrees,"s":..,"v":..,"bin":[h,s,v]}, or "grey":v in
/// place of the bin; 17 significant digits. Blank lines are passed over. A bad
/// line (also one longer than kLongestLine bytes) gives {"error":".."} in its
/// place, and kFailed at the end. Throws FileError where reading or printing
/// fails.
int run_hsv(int descriptor, const Session& session);

}  // namespace sir::cli
