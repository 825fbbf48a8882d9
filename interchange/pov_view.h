// Camera and lights for POV-Ray, and the frame in which it gets the scene
// (thesis 2.3.3, 3.6.2, 3.6.3).
#pragma once

#include <string>

#include "tracer/scene.h"

namespace sir {

/// From SC_CENA to POV-Ray's coordinates: p' = factor (p - centre).
struct PovFrame {
  glm::dvec3 centre{0};
  double factor = 1;
  glm::dvec3 apply(const glm::dvec3& p) const { return factor * (p - centre); }
};

/// The frame in which the diagonal of a box around the primitives, the screen's
/// centre and the eye lies within (2^19, 2^20]: `factor` is a power of two, and
/// `centre` is the box's, rounded to a multiple of the power of two not below
/// the diagonal, hence 0 for a scene that is not far from its origin.
PovFrame fitting_frame(const Scene& scene);

/// `<a,b,c>` with as many digits as read back to the same bits.
std::string pov_vector(const glm::dvec3& v);

/// camera { ... }, background { ... } and the light_sources.
std::string pov_view(const Scene& scene, const PovFrame& frame);

/// Whether a primitive may have surface in the pyramid between the eye and the
/// screen, which POV-Ray's rays cross and ours do not. Judged by boxes: may be
/// true where none has, never the other way round.
bool reaches_before_screen(const Scene& scene);

/// The half space behind the screen, seen from the eye, as an object.
std::string pov_half_space_of_scene(const Scene& scene, const PovFrame& frame);

}  // namespace sir
