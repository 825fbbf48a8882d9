// The tree of a pixel's rays and surfaces, kept for a person to read (thesis
// 2.4.2, fig. 2.3).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "tracer/scene.h"

namespace sir {

enum class RayKind : std::uint8_t { primary, reflected, refracted };

/// One ray of the tree and the surface that it meets.
struct TraceNode {
  static constexpr std::size_t kNoParent = static_cast<std::size_t>(-1);
  std::size_t parent = kNoParent;
  RayKind kind = RayKind::primary;
  int depth = 1;
  double weight = 1;  ///< product of the factors from the pixel down to this ray
  double factor = 1;  ///< ks, kt or (total reflection) ks + kt of the parent's surface
  glm::dvec3 origin{0}, direction{0};
  bool hit = false;  ///< false: the ray leaves the scene and sees the background
  double t = 0;
  bool entering = false;
  std::int64_t node = 0;
  int face = 0;
  std::size_t surface = 0;  ///< index into Scene::surfaces
  Coefficients coefficients;
  glm::dvec3 point{0}, normal{0};
  std::vector<glm::dvec3> lights;  ///< intensity that reaches the point from each light
  bool total_reflection = false;
  glm::dvec3 local{0};   ///< ambient, diffuse and highlights
  glm::dvec3 colour{0};  ///< with what the rays below bring
};

using TraceLog = std::vector<TraceNode>;

/// The tree as indented lines: each ray, the surface it meets with its
/// coefficients, the weight, the lights and the colour.
std::string describe(const TraceLog& log, const Scene& scene);

}  // namespace sir
