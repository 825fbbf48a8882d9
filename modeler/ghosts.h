// What differences take away, made visible. In the thesis's pictures a subtracted solid leaves no
// trace but its hole (2.3.1).
#pragma once

#include <stop_token>
#include <vector>

#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// How much of a ghost is seen at a pixel: 0 none, else how bright it is.
using GhostLayer = std::vector<std::uint8_t>;

/// The scene in which nothing is taken away: differences are unions, and what they would have taken
/// is bright, all else black. Traced like any solid, it shows the ghosts where they are in front,
/// and only there. False where there is no difference.
bool make_ghost_scene(const Scene& scene, Scene& ghosts);

/// The ghosts as one primary ray a pixel sees them, without shadows; `block` as in
/// render_preview(). Empty where stopped.
GhostLayer ghost_layer(const Scene& ghosts, ImageSize size, int threads, int block,
                       const std::stop_token& stop);

/// Lays a fixed share of the ghosts over a picture of the same size.
void blend(const GhostLayer& ghosts, Planes& picture);

}  // namespace sir::modeler
