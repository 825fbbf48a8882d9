// Where a picture lies in a window: whole multiples, centred. Stands for the
// monitor's glass (thesis 3.5); the thesis has no windows.
#pragma once

#include "tracer/planes.h"

namespace sir::viewer {

inline constexpr int kMaxMultiple = 64;

/// A rectangle in window pixels; it may reach beyond the window.
struct Letterbox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const Letterbox&, const Letterbox&) = default;
};

/// The largest multiple, 1..kMaxMultiple, at which the picture fits the
/// window; 1 where none does.
int largest_multiple(ImageSize window, ImageSize picture);

/// The next multiple to zoom to, and the one before: 1 to 6 one by one, then in steps of about a
/// quarter, up to kMaxMultiple and down to 1.
int next_multiple(int multiple);
int previous_multiple(int multiple);

/// The picture at a whole multiple, centred. Where it is larger than the
/// window its centre shows.
Letterbox centre(ImageSize window, ImageSize picture, int multiple);

}  // namespace sir::viewer
