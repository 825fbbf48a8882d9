// From an image to the screen of the MA120.
#pragma once

#include "tracer/planes.h"

namespace sir::fuzz {

/// The thesis's four ways to a LUT, then `best` by the eye and by the bytes.
inline constexpr int kMethods = 6;

/// Of so many inputs each method serves one, and the rest end with the image: a LUT and a screen of
/// the MA120 take longer than all of a small image before them.
inline constexpr int kShownOnceIn = 4 * kMethods;

/// Chooses a LUT by a method, 0 to kMethods - 1, or does nothing for another number; maps the image
/// to it by the fast search and by the definition, and sends it to the display. Fails where the two
/// differ, where the LUT's file does not read as the LUT, and where a pixel on the screen has
/// another colour than its entry.
void show_by_method(const Planes& image, int method);

}  // namespace sir::fuzz
