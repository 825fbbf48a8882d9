#include "tracer/recentre.h"

#include "tracer/bounds.h"

namespace sir {

glm::dvec3 offset_for(const Scene& scene, Precision precision) {
  if (precision != Precision::float_) return glm::dvec3(0);
  Bounds<double> all;
  for (const CsgNode& node : scene.tree.nodes) {
    if (node.composite) continue;
    LocalCena<double> placement;
    placement.linear = node.placement.linear;
    placement.translation = node.placement.translation;
    all.include(bounds_of(node.kind, placement));
  }
  const glm::dvec3 centre = all.centre(), size = all.high - all.low;
  const double away = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
  constexpr double kSizes = 16;
  if (!(away > kSizes * std::max({size.x, size.y, size.z}))) return glm::dvec3(0);
  const glm::dvec3 offset(glm::vec3{centre});
  const bool fits = std::isfinite(offset.x) && std::isfinite(offset.y) && std::isfinite(offset.z);
  return fits ? offset : glm::dvec3(0);
}

Scene recentred(Scene scene, const glm::dvec3& offset) {
  if (offset == glm::dvec3(0)) return scene;
  for (CsgNode& node : scene.tree.nodes) node.placement.translation -= offset;
  for (Light& light : scene.lighting.lights) light.position -= offset;
  scene.camera.target -= offset;
  return scene;
}

}  // namespace sir
