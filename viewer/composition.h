// What is laid over the monitor's picture: the reference, maps, the other half of a duel. The
// monitor itself (thesis 3.5) knows none of it.
#pragma once

#include <cstdint>
#include <span>

#include "eltek/display_driver.h"
#include "viewer/frame.h"

namespace sir::viewer {

/// Lays an image over the part of the frame where the display program put it: `at` is its
/// placement, `origin` the screen's pixel that is the frame's upper left corner.
void lay_over(Frame& frame, const Planes& image, const eltek::Placement& at,
              const eltek::Area& frame_on_screen);

/// Takes over the columns from `column` on of another frame of the same size.
void take_right_part(Frame& frame, const Frame& other, int column);

/// Leaves the pixels whose index is `entry` as they are and dims the rest to a dark grey of their
/// lightness. One index a pixel of the frame.
void leave_entry(Frame& frame, std::span<const std::uint8_t> indices, std::uint8_t entry);

}  // namespace sir::viewer
