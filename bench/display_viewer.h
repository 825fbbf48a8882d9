// The viewer's own way from a new LUT to its window's texture, for display_bench.
#pragma once

namespace sir::bench {

/// Prints medians, for the whole screen and the image's area, plain and with what a person may have
/// opened. Needs no display. Throws where SDL fails.
void time_viewer();

}  // namespace sir::bench
