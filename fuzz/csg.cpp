// The solid's file, BASE.CSG.
#include "fuzz/round_trip.h"
#include "fuzz/same.h"
#include "fuzz/targets.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {

void play_csg(Bytes bytes) {
  play_round_trip("F.CSG", bytes, read_csg, csg_text, [](const CsgTree& a, const CsgTree& b) {
    require(depth_of(a) == depth_of(b), "a tree's depth is that of what is written");
    return same(a, b);
  });
}

}  // namespace sir::fuzz
