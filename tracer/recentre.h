// Where to put the origin of SC_CENA for float (BASICO's initialisation, thesis
// 3.3): far from the origin a float has few digits left for the place of things.
#pragma once

#include <optional>

#include "tracer/render.h"
#include "tracer/scene.h"

namespace sir {

/// What to subtract from every position of the scene before it is rounded to the
/// precision: 0 for double and wider, and for scenes within 16 of their sizes of the
/// origin, whose numbers had better stay as they are; else the centre of the
/// primitives' envelope, cut to float so that differences are short.
glm::dvec3 offset_for(const Scene& scene, Precision precision);

/// The scene with the offset subtracted from solids, lights and camera; the scene
/// itself, which must then outlive it, where there is none.
class Recentred {
 public:
  Recentred(const Scene& scene, const glm::dvec3& offset);
  operator const Scene&() const { return moved_ ? *moved_ : scene_; }  // NOLINT: it is one

 private:
  const Scene& scene_;
  std::optional<Scene> moved_;
};

}  // namespace sir
