// Scenes made in code, for tests.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir::test {

/// Puts a CSG tree together from the leaves up. Node numbers count from 0 in
/// the order of creation unless given.
class SceneBuilder {
 public:
  using Id = std::size_t;  ///< index into Scene::tree.nodes

  Id primitive(PrimitiveKind kind, const Placement& placement = {}, std::int64_t surface = 1,
               std::int64_t number = -1);
  Id cube(glm::dvec3 low, glm::dvec3 high, std::int64_t surface = 1, std::int64_t number = -1);
  Id sphere(glm::dvec3 centre, double radius, std::int64_t surface = 1, std::int64_t number = -1);
  Id combine(Operation operation, Id left, Id right);

  /// A union of small solids side by side and through one another, most of them cut by
  /// one or two more; on a coarse grid with `aligned`.
  Id crowd(std::mt19937_64& random, int parts, bool aligned);

  /// A matt white surface unless the caller changes it.
  Surface& surface(std::int64_t number);

  /// The scene with `root` as its root. Surfaces named by primitives exist.
  Scene finish(Id root);

  Scene scene;
};

/// A placement that scales, then moves.
Placement placed(glm::dvec3 scale, glm::dvec3 translation);

/// A turned, scaled, moved placement; `shear` adds shears and mirrors.
Placement random_placement(std::mt19937_64& random, double size, bool shear);

/// A random tree of `leaves` primitives of random kinds; on a coarse grid with
/// `aligned`, so that faces coincide often.
Scene random_scene(std::uint64_t seed, int leaves, bool aligned);

/// The same scene with every primitive and light moved and scaled about the
/// origin of SC_CENA: p' = factor p + offset, the camera with it.
Scene moved(Scene scene, double factor, glm::dvec3 offset);

}  // namespace sir::test
