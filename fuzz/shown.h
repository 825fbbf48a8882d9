// From an image to the screen of the MA120.
#pragma once

#include "tracer/planes.h"

namespace sir::fuzz {

/// Chooses a LUT by every method of the thesis, and by `best` (by the eye where `by_eye`, else by
/// the bytes); maps the image to it by the fast search and by the definition, and sends it to the
/// display. Fails where the two differ, where the LUT's file does not read as the LUT, and where a
/// pixel on the screen has another colour than its entry.
void show_by_every_method(const Planes& image, bool by_eye);

}  // namespace sir::fuzz
