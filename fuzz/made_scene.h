// A small scene out of any bytes.
#pragma once

#include "fuzz/byte_source.h"
#include "tracer/scene.h"

namespace sir::fuzz {

/// Up to 12 primitives in any composition, up to 4 surfaces, up to 3 lights, and a camera. What
/// the files could not hold, such as a singular matrix, may be among it: readers refuse that.
Scene made_scene(ByteSource& source);

}  // namespace sir::fuzz
