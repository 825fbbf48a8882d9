// A camera that goes round a scene: frames a second, and POV-Ray's time of one.
#pragma once

#include <filesystem>

#include "bench/peers_table.h"
#include "tracer/scene.h"

namespace sir::bench {

/// Each round `frames` of 640x480, depth 5 and full shading on two threads, the camera on a circle
/// about the target; wall time. The scene is made ready once for each precision, a frame changes
/// the camera only; double and float take turns. Beside them what POV-Ray takes for the first of
/// the frames on two threads, start and parsing included; nothing without it. Its files go into
/// `folder`, the working folder.
void measure_orbit(const Scene& scene, int rounds, int frames, bool povray,
                   const std::filesystem::path& folder, SpeedTable& table);

}  // namespace sir::bench
