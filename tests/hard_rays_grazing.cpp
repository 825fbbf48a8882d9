// Rays beside a tangent by 10^-1 ... 10^-15 of the size, and exact tangents.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

// A point of the surface in units of 1/denominator, an outward normal there and
// a tangent, all in short integers of SC_LOCAL.
struct Touch {
  glm::dvec3 point, normal, tangent;
  double denominator;
};

Touch on_sphere(Dice& dice) {
  const Quadruple q = quadruple(dice);
  return {q.numerator, q.numerator, across(dice, q.numerator), q.denominator};
}

Touch on_cylinder(Dice& dice) {
  const Quadruple q = triple(dice);
  const glm::dvec3 at = q.numerator + glm::dvec3(0, dice.between(1, 4), 0);
  return {at, q.numerator, across(dice, q.numerator), q.denominator};
}

Touch on_cone(Dice& dice) {
  // Half-way up; the gradient of x^2 + z^2 - (1-y)^2 is (x, 1-y, z).
  const Quadruple q = triple(dice);
  const glm::dvec3 at = q.numerator + glm::dvec3(0, q.denominator, 0);
  return {at, at, across(dice, at), 2 * q.denominator};
}

// The rim of a cap: any normal between those of the cap and the side supports it.
Touch on_rim(Dice& dice, PrimitiveKind kind) {
  const Quadruple q = triple(dice);
  const bool top = kind == PrimitiveKind::cylinder && dice.coin();
  glm::dvec3 normal = q.numerator * static_cast<double>(dice.between(1, 3));
  normal.y = (top ? 1 : -1) * q.denominator * dice.between(1, 2);
  return {q.numerator + glm::dvec3(0, top ? q.denominator : 0, 0), normal, across(dice, normal),
          q.denominator};
}

// Moves the touch by offset (relative to the size) along the normal. Variant 0:
// axes and powers of two where that is possible, 1: an integer matrix, whose
// images are exact but for the offset, 2: nothing is exact.
HardRay beside(Dice& dice, PrimitiveKind kind, const Touch& touch, double offset, int variant) {
  Placement placement;
  if (variant == 0) placement = placed(glm::dvec3(touch.denominator), dice.integers(4));
  if (variant == 1) placement = short_placement(dice, touch.denominator);
  if (variant == 2) placement = general_placement(dice);
  const glm::dvec3 outwards = touch.normal / glm::length(touch.normal);
  const glm::dvec3 point = touch.point / touch.denominator + offset * outwards;
  glm::dvec3 at = to_scene(placement, point);
  if (variant < 2)  // exact up to the offset
    at = placement.linear / touch.denominator * touch.point + placement.translation +
         placement.linear * outwards * offset;
  const double back = variant < 2 ? dice.between(0, 6) : dice.real(0, 6);
  return through(
      {alone(kind, placement), at, placement.linear / touch.denominator * touch.tangent, back});
}

template <typename Make>
std::vector<HardRay> graze(Dice& dice, PrimitiveKind kind, Make make) {
  std::vector<HardRay> rays;
  for (int k = 1; k <= 15; ++k)
    for (const int side : {-1, 1})
      for (int variant = 0; variant < 3; ++variant)
        rays.push_back(beside(dice, kind, make(dice), side * ten(-k), variant));
  return rays;
}

std::vector<HardRay> grazing_sphere(Dice& dice) {
  std::vector<HardRay> rays = graze(dice, PrimitiveKind::sphere, on_sphere);
  // Along an axis, where the impact parameter is the input itself.
  for (int k = 1; k <= 15; ++k)
    for (const int side : {-1, 1})
      rays.push_back({alone(PrimitiveKind::sphere, {}), {1 + side * ten(-k), 0, -3}, {0, 0, 1}});
  return rays;
}
std::vector<HardRay> grazing_cylinder(Dice& dice) {
  return graze(dice, PrimitiveKind::cylinder, on_cylinder);
}
std::vector<HardRay> grazing_cone(Dice& dice) { return graze(dice, PrimitiveKind::cone, on_cone); }
std::vector<HardRay> grazing_rim(Dice& dice) {
  std::vector<HardRay> rays;
  for (const PrimitiveKind kind : {PrimitiveKind::cylinder, PrimitiveKind::cone})
    for (const HardRay& ray : graze(dice, kind, [kind](Dice& d) { return on_rim(d, kind); }))
      rays.push_back(ray);
  return rays;
}

// Tangents that are exact in the doubles of scene and ray: always OUT. In a
// third of the cases the solid is cut out of another one or joined with it.
std::vector<HardRay> tangent(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 150; ++n) {
    const int which = n % 5;
    const PrimitiveKind kind = which == 0   ? PrimitiveKind::sphere
                               : which == 1 ? PrimitiveKind::cylinder
                               : which == 2 ? PrimitiveKind::cone
                               : which == 3 ? PrimitiveKind::cylinder
                                            : PrimitiveKind::cone;
    const Touch touch = which == 0   ? on_sphere(dice)
                        : which == 1 ? on_cylinder(dice)
                        : which == 2 ? on_cone(dice)
                                     : on_rim(dice, kind);
    HardRay ray = beside(dice, kind, touch, 0, n % 2);
    if (n % 3 == 0) {
      const CsgNode& node = ray.scene->tree.nodes[0];
      const Part block{PrimitiveKind::cube, placed(glm::dvec3(64), glm::dvec3(-32))};
      ray.scene = pair_of(dice, kOperations[static_cast<std::size_t>(dice.below(3))], block,
                          {node.kind, node.placement});
    }
    rays.push_back(ray);
  }
  return rays;
}

// The same with matrices and rays rounded to the nearest double: within a few
// roundings of a tangent, on either side.
std::vector<HardRay> tangent_rounded(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 90; ++n) {
    const PrimitiveKind kind = kQuadrics[static_cast<std::size_t>(n % 3)];
    const Touch touch = n % 3 == 0   ? on_sphere(dice)
                        : n % 3 == 1 ? on_cone(dice)
                                     : on_cylinder(dice);
    rays.push_back(beside(dice, kind, touch, 0, 2));
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_grazing() {
  return {{"grazing_sphere", grazing_sphere},
          {"grazing_cylinder", grazing_cylinder},
          {"grazing_cone", grazing_cone},
          {"grazing_rim", grazing_rim},
          {"tangent", tangent},
          {"tangent_rounded", tangent_rounded}};
}

}  // namespace sir::test
