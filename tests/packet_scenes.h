// Scenes and rays for the tests of packets.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "tests/scene_builder.h"
#include "tracer/packet.h"

namespace sir::test {

/// A union of `parts` solids A, A-B, A-B-C or A^B, about `size` large, in [-2, 2]^3;
/// on a coarse grid with `aligned`, so that faces coincide often.
Scene union_of_parts(std::uint64_t seed, int parts, double size, bool aligned);

/// Instruction sets that packets are compiled for and this machine has, the one of
/// one lane last. `run` is called with each in force.
void with_each_instruction_set(const std::function<void(const char* name)>& run);

}  // namespace sir::test
