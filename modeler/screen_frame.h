// SC_OBS as seen from SC_CENA (thesis 2.3.3): where the screen stands, for what is not traced.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "tracer/numeric.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// Three unit vectors and the screen's centre, in SC_CENA, as Camera has them.
struct ScreenFrame {
  glm::dvec3 right, up, normal, origin;

  explicit ScreenFrame(const CameraFile& camera)
      : normal(glm::normalize(scaled_near_one(camera.normal))) {
    right = glm::normalize(glm::cross(normal, scaled_near_one(camera.up)));
    up = glm::cross(right, normal);
    origin = camera.target - camera.distance * normal;
  }

  /// A point of SC_CENA in SC_OBS.
  glm::dvec3 observe(const glm::dvec3& point) const {
    const glm::dvec3 from = point - origin;
    return {glm::dot(right, from), glm::dot(up, from), glm::dot(normal, from)};
  }
};

}  // namespace sir::modeler
