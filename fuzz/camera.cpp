// The camera's file, BASE.CAM.
#include "fuzz/round_trip.h"
#include "fuzz/same.h"
#include "fuzz/targets.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {

void play_camera(Bytes bytes) {
  play_round_trip("F.CAM", bytes, read_camera, camera_text,
                  [](const CameraFile& a, const CameraFile& b) { return same(a, b); });
}

}  // namespace sir::fuzz
