// Rays that begin on a surface, inside a solid, and where solids overlap.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

// A point of a face of the primitive, in units of 1/denominator.
Quadruple surface_point(Dice& dice, PrimitiveKind kind) {
  if (kind == PrimitiveKind::sphere) return quadruple(dice);
  if (kind == PrimitiveKind::cube) {
    glm::dvec3 at = 8.0 * inner_point(dice, kind);
    at[dice.below(3)] = 8 * dice.below(2);
    return {at, 8};
  }
  const Quadruple q = triple(dice);
  if (dice.coin()) return {8.0 * inner_point(dice, kind) * glm::dvec3(1, 0, 1), 8};  // a base
  if (kind == PrimitiveKind::cone)
    return {q.numerator + glm::dvec3(0, q.denominator, 0), 2 * q.denominator};
  return {2.0 * q.numerator + glm::dvec3(0, dice.between(1, 3), 0), 2 * q.denominator};
}

// Exactly on it: integer matrices that are a multiple of the denominator.
std::vector<HardRay> on_surface(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Quadruple at = surface_point(dice, kind);
    Placement placement = n % 3 ? short_placement(dice) : placed(glm::dvec3(1), dice.integers(5));
    const glm::dvec3 origin = to_scene(placement, at.numerator);
    placement.linear *= at.denominator;
    rays.push_back({alone(kind, placement), origin, dice.integers(4)});
  }
  return rays;
}

// As near to it as doubles come: a whole span before or behind by a rounding.
std::vector<HardRay> on_surface_rounded(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Quadruple at = surface_point(dice, kind);
    const Placement placement = general_placement(dice);
    const glm::dvec3 origin = to_scene(placement, at.numerator / at.denominator);
    rays.push_back({alone(kind, placement), origin, dice.reals(-1, 1)});
  }
  return rays;
}

std::vector<HardRay> inside(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 80; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Placement placement = n % 3 ? general_placement(dice) : short_placement(dice);
    const glm::dvec3 origin = to_scene(placement, inner_point(dice, kind));
    rays.push_back({alone(kind, placement), origin, dice.reals(-1, 1)});
  }
  return rays;
}

// Inside two solids at once, or one and a hole, some with the start on a face of
// one of them.
std::vector<HardRay> in_overlap(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const PrimitiveKind other = kKinds[static_cast<std::size_t>(dice.below(4))];
    const Placement left = n % 2 ? general_placement(dice) : short_placement(dice);
    Placement right = n % 2 ? general_placement(dice) : short_placement(dice);
    const glm::dvec3 in_left = inner_point(dice, kind), in_right = inner_point(dice, other);
    const glm::dvec3 origin = to_scene(left, in_left);
    right.translation += origin - to_scene(right, in_right);
    const Operation operation = kOperations[static_cast<std::size_t>(n % 3)];
    const Shared scene = pair_of(dice, operation, {kind, left}, {other, right});
    rays.push_back({scene, origin, n % 4 ? dice.reals(-1, 1) : dice.integers(3)});
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_start() {
  return {{"start_on_surface", on_surface},
          {"start_on_surface_rounded", on_surface_rounded},
          {"start_inside", inside},
          {"start_in_overlap", in_overlap}};
}

}  // namespace sir::test
