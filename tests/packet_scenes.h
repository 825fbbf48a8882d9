// Scenes and rays for the tests of packets.
#pragma once

#include <random>
#include <vector>

#include "tests/scene_builder.h"
#include "tracer/packet.h"

namespace sir::test {

/// A union of `parts` solids A, A-B, A-B-C or A^B, about `size` large, in [-2, 2]^3;
/// on a coarse grid with `aligned`, so that faces coincide often.
Scene union_of_parts(std::uint64_t seed, int parts, double size, bool aligned);

}  // namespace sir::test
