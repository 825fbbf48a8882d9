// Quadrics far away, tiny, and huge with the eye near them.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

// A primitive of size 1 seen from 10^k sizes; one ray in three passes within a
// thousandth of the silhouette.
std::vector<HardRay> far(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 2; k <= 8; ++k)
    for (const PrimitiveKind kind : kQuadrics)
      for (int variant = 0; variant < 4; ++variant) {
        const Placement placement =
            variant == 0 ? aligned_placement(dice) : general_placement(dice);
        glm::dvec3 point = inner_point(dice, kind);
        if (variant == 3) point = quadruple(dice).numerator / 16.0 + glm::dvec3(0, 0.5, 0);
        const glm::dvec3 along = dice.reals(-1, 1);
        const double distance = 0.4 * ten(k) / glm::length(along);
        rays.push_back(
            through({alone(kind, placement), to_scene(placement, point), along, distance}));
      }
  return rays;
}

std::vector<HardRay> tiny(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 1; k <= 8; ++k)
    for (const PrimitiveKind kind : kKinds)
      for (int variant = 0; variant < 3; ++variant) {
        Placement placement = general_placement(dice, ten(-k));
        placement.translation = dice.reals(-3, 3);
        rays.push_back(
            through({alone(kind, placement), to_scene(placement, inner_point(dice, kind)),
                     dice.reals(-1, 1), dice.real(1, 8)}));
      }
  return rays;
}

// The eye at a height of about 1 over a surface of radius 10^k: down, along the
// horizon, up and away, and from below the surface outwards.
std::vector<HardRay> huge(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 2; k <= 8; ++k)
    for (const PrimitiveKind kind : kQuadrics)
      for (int variant = 0; variant < 5; ++variant) {
        const double radius = ten(k);
        Placement placement;
        placement.linear = radius * (variant % 2 ? rotation(dice) : glm::dmat3(1));
        const Quadruple q = kind == PrimitiveKind::sphere ? quadruple(dice) : triple(dice);
        glm::dvec3 surface = q.numerator / q.denominator, normal = surface;
        if (kind == PrimitiveKind::cylinder) surface.y = dice.real(0.2, 0.8);
        if (kind == PrimitiveKind::cone) {
          surface = glm::dvec3(0.5 * surface.x, 0.5, 0.5 * surface.z);
          normal.y = 1;
        }
        placement.translation = -(placement.linear * surface);  // the surface near the origin
        const glm::dvec3 up = placement.linear * normal / radius;
        const glm::dvec3 aside = glm::cross(up, dice.reals(-1, 1));
        const double height = variant == 4 ? -dice.real(0.1, 5) : dice.real(0.001, 5);
        const double steepness[] = {-1, -0.1, -ten(-dice.between(2, 6)), 0.01, 0.5};
        rays.push_back({alone(kind, placement), height * up + dice.reals(-1, 1) * 0.001,
                        aside + steepness[variant] * up});
      }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_distance() {
  return {{"quadratic_far", far}, {"quadratic_tiny", tiny}, {"quadratic_huge", huge}};
}

}  // namespace sir::test
