// Lines for orientation: axes, bounds, a grid. The thesis shows ENVOLTORIO as numbers only
// (3.2.2.10).
#pragma once

#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

#include "modeler/pick.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// A straight line in SC_CENA.
struct GuideLine {
  glm::dvec3 from{0}, to{0};
  Rgb8 colour;
};

/// X red, Y green, Z blue, from the origin on, as far as the box reaches.
std::vector<GuideLine> axes(const Box& bounds);

/// The twelve edges of a box.
std::vector<GuideLine> edges(const Box& bounds);

/// A grid in the plane Y = 0 under, or over, the box; its step is 1, 2 or 5 times a power of ten,
/// about a tenth of the box.
std::vector<GuideLine> grid(const Box& bounds);

/// A pixel of a line: so much of the colour, in [0,1], covers what is there.
struct GuidePixel {
  std::size_t pixel = 0;
  Rgb8 colour;
  double share = 0;
};

/// The lines as pixels, one wide. What lies behind the solid, where the ray through the pixel's
/// centre meets it first, is faint. `picker` is of the same camera and size, or null: no solid.
/// After a stop request not all lines are there.
std::vector<GuidePixel> pixels_of(const std::vector<GuideLine>& lines, const CameraFile& camera,
                                  ImageSize size, Picker* picker, const std::stop_token& stop = {});

/// Draws them over a picture.
void draw(const std::vector<GuidePixel>& pixels, Planes& picture);

/// A mix of two colours, `share` of the second.
Rgb8 mixed(Rgb8 under, Rgb8 over, double share);

}  // namespace sir::modeler
