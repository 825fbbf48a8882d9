#include "tracer/recentre.h"

#include "tracer/bounds.h"

namespace sir {

glm::dvec3 offset_for(const Scene& scene, Precision precision) {
  if (precision != Precision::float_) return glm::dvec3(0);
  constexpr double kSizes = 16;
  Bounds<double> all;
  glm::dvec3 centre(0);
  double away = 0, size = 0;
  for (const CsgNode& node : scene.tree.nodes) {
    if (node.composite) continue;
    LocalCena<double> placement;
    placement.linear = node.placement.linear;
    placement.translation = node.placement.translation;
    all.include(bounds_of(node.kind, placement));
    centre = all.centre();
    const glm::dvec3 extent = all.high - all.low;
    away = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
    size = std::max({extent.x, extent.y, extent.z});
    // More primitives can move the centre by no more than half of the size.
    if (away <= (kSizes - 1) * size) return glm::dvec3(0);
  }
  if (!(away > kSizes * size)) return glm::dvec3(0);
  const glm::dvec3 offset(glm::vec3{centre});
  const bool fits = std::isfinite(offset.x) && std::isfinite(offset.y) && std::isfinite(offset.z);
  return fits ? offset : glm::dvec3(0);
}

Recentred::Recentred(const Scene& scene, const glm::dvec3& offset) : scene_(scene) {
  if (offset == glm::dvec3(0)) return;
  moved_ = scene;
  for (CsgNode& node : moved_->tree.nodes) node.placement.translation -= offset;
  for (Light& light : moved_->lighting.lights) light.position -= offset;
  moved_->camera.target -= offset;
}

}  // namespace sir
