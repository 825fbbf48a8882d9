// The surfaces' file, BASE.SUP.
#include "fuzz/round_trip.h"
#include "fuzz/same.h"
#include "fuzz/targets.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {

void play_surfaces(Bytes bytes) {
  play_round_trip(
      "F.SUP", bytes, read_surfaces, surfaces_text,
      [](const std::vector<Surface>& a, const std::vector<Surface>& b) { return same(a, b); });
}

}  // namespace sir::fuzz
