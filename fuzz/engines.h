// Every way to an image, against the plain one.
#pragma once

#include "tracer/render.h"

namespace sir::fuzz {

/// The image of Roth's plain algorithm, one ray after the other, in the precision of the options.
/// Fails where another engine, packets on any instruction set, or the tree behind a pixel gives
/// another byte. Of the options size, precision and what is traced are looked at.
Planes image_by_all_engines(const Scene& scene, RenderOptions options);

}  // namespace sir::fuzz
