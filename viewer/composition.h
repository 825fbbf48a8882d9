// What is laid over the monitor's picture: the reference, maps, an entry that stands out. The
// monitor itself (thesis 3.5) knows none of it.
#pragma once

#include <cstdint>

#include "eltek/display_driver.h"
#include "viewer/frame.h"
#include "viewer/station.h"

namespace sir::viewer {

/// Lays an image over some columns of a frame, where the display program put it: `at` is its
/// placement, `frame_on_screen` what the frame shows of the screen.
void lay_over(Frame& frame, const Planes& image, const eltek::Placement& at,
              const eltek::Area& frame_on_screen, const Columns& columns);

/// What a colour is in the background: a dark grey of its lightness.
Argb in_background(Argb colour);

/// Leaves the words of the indices that reach the LUT as `entry` under the mask, and puts the rest
/// into the background.
void leave_entry(IndexWords& words, std::uint8_t mask, std::uint8_t entry);

}  // namespace sir::viewer
