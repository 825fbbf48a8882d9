// The light's file, BASE.LUZ.
#include "fuzz/round_trip.h"
#include "fuzz/same.h"
#include "fuzz/targets.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {

void play_light(Bytes bytes) {
  play_round_trip("F.LUZ", bytes, read_lighting, lighting_text,
                  [](const Lighting& a, const Lighting& b) { return same(a, b); });
}

}  // namespace sir::fuzz
