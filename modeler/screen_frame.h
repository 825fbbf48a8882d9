// SC_OBS as seen from SC_CENA (thesis 2.3.3): where the screen stands, for what is not traced.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
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

  /// From directions of SC_CENA to those of SC_OBS.
  glm::dmat3 turn() const { return glm::transpose(glm::dmat3(right, up, normal)); }

  /// A direction of SC_OBS in SC_CENA.
  glm::dvec3 turned_back(const glm::dvec3& way) const {
    return way.x * right + way.y * up + way.z * normal;
  }
};

}  // namespace sir::modeler
