// From an image to the screen of the MA120.
#pragma once

#include "tracer/planes.h"

namespace sir::fuzz {

/// The thesis's four ways to a LUT, then `best` by the eye and by the bytes. One for each input: a
/// screen of the MA120 takes longer than all of a small image before it.
inline constexpr int kMethods = 6;

/// Chooses a LUT by a method, 0 to kMethods - 1; maps the image to it by the fast search and by the
/// definition, and sends it to the display. Fails where the two differ, where the LUT's file does
/// not read as the LUT, and where a pixel on the screen has another colour than its entry.
void show_by_method(const Planes& image, int method);

}  // namespace sir::fuzz
