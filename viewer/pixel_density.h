// The window's units against the pixels that it is drawn with, which on dense displays are finer.
// The thesis's monitor had one kind.
#pragma once

#include <algorithm>
#include <cstdint>

namespace sir::viewer {

/// As one length of the window is in both.
struct PixelDensity {
  int units = 1, pixels = 1;  ///< both at least 1

  /// The pixel at a place in units.
  int pixel_at(int place) const { return divided(std::int64_t{place} * pixels, units); }

  /// The pixels that so many units touch, and the least units that hold so many pixels: rounded up,
  /// so that at 1.25 or 1.5 pixels a unit nothing is cut off or lies over another.
  int pixels_of(int length) const { return -divided(-std::int64_t{length} * pixels, units); }
  std::int64_t units_of(std::int64_t length) const {
    return (length * units + pixels - 1) / pixels;
  }

  /// How many times letters are drawn larger: the nearest whole number, at least 1.
  int scale() const { return std::max(1, (pixels + units / 2) / units); }

 private:
  /// Rounded down.
  static int divided(std::int64_t length, int by) {
    return static_cast<int>(length / by - (length % by < 0 ? 1 : 0));
  }
};

}  // namespace sir::viewer
