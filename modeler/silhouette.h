// Mostra sólido (thesis 3.2.2.9): lines where the surface changes, and the same solid shaded.
#pragma once

#include <stop_token>
#include <string>

#include "modeler/node.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// White lines on black: a pixel is lit where the ray through its centre meets a surface of another
/// number than the one through the pixel above it, or through the one to its left (superfície[x,y]
/// <> superfície[x,y-1], superfície[x-1,y]); to meet none counts as a number of its own, and so do
/// rays just outside the image. Lines half a pixel above or to the left, as the thesis has them,
/// are on the pixel itself. Rays are sent only where the solid's bounds in SC_OBS are seen.
/// All black where `stop` ends it early.
Planes silhouette(const Node& tree, const Scene& scene, ImageSize size,
                  const std::stop_token& stop = {});

/// Lit pixels as characters U+2800 to U+28FF, 2 by 4 pixels each, a line for every four rows; white
/// space at the end of lines is left out.
std::string in_dots(const Planes& picture);

}  // namespace sir::modeler
