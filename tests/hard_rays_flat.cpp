// Edges and corners of cubes, rays parallel to axes and faces, and in faces.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

constexpr PrimitiveKind kCube = PrimitiveKind::cube;

Placement any_placement(Dice& dice, int variant) {
  if (variant % 3 == 0) return aligned_placement(dice);
  return variant % 3 == 1 ? short_placement(dice) : general_placement(dice);
}

// Zeros of either sign, as they come out of other programs.
glm::dvec3 with_signed_zeros(Dice& dice, glm::dvec3 v) {
  for (int i = 0; i < 3; ++i)
    if (v[i] == 0) v[i] = dice.coin() ? 0.0 : -0.0;
  return v;
}

// Through a point where `fixed` coordinates are 0 or 1: 2 an edge, 3 a corner.
std::vector<HardRay> through_rim(Dice& dice, int fixed) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 60; ++n) {
    const Placement placement = any_placement(dice, n);
    glm::dvec3 point = inner_point(dice, kCube);
    const int first = dice.below(3);
    for (int i = 0; i < fixed; ++i) point[(first + i) % 3] = dice.below(2);
    rays.push_back(through(
        {alone(kCube, placement), placement, point, dice.integers(4), 0.5 * dice.between(-1, 6)}));
  }
  // Beside it by 10^-k.
  for (int k = 1; k <= 15; ++k)
    for (int variant = 0; variant < 3; ++variant) {
      const Placement placement = any_placement(dice, variant);
      glm::dvec3 point = inner_point(dice, kCube);
      const int first = dice.below(3);
      for (int i = 0; i < fixed; ++i)
        point[(first + i) % 3] = dice.below(2) + ten(-k) * dice.between(-2, 2);
      rays.push_back(through({alone(kCube, placement), placement, point, dice.integers(4),
                              0.5 * dice.between(-1, 6)}));
    }
  return rays;
}
std::vector<HardRay> edge(Dice& dice) { return through_rim(dice, 2); }
std::vector<HardRay> corner(Dice& dice) { return through_rim(dice, 3); }

// Along the axes of SC_CENA, with zeros of both signs.
std::vector<HardRay> parallel_axis(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Placement placement = n % 8 < 4 ? aligned_placement(dice) : any_placement(dice, n / 8);
    glm::dvec3 along(0);
    along[dice.below(3)] = dice.sign() * dice.between(1, 3);
    const glm::dvec3 point = to_scene(placement, inner_point(dice, kind));
    rays.push_back(through({alone(kind, placement), point, with_signed_zeros(dice, along),
                            double(dice.between(-1, 6))}));
  }
  return rays;
}

// Parallel to a face and beside or between: one or two coordinates of the
// direction in SC_LOCAL are zero, exactly or up to a rounding.
std::vector<HardRay> parallel_face(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = n % 4 == 3 ? PrimitiveKind::cylinder : kCube;
    const Placement placement = any_placement(dice, n);
    glm::dvec3 along = dice.integers(3);
    along[kind == kCube ? dice.below(3) : 1] = 0;
    if (along == glm::dvec3(0)) along.x = -1;
    glm::dvec3 point = inner_point(dice, kind);
    if (n % 5 == 0) point[kind == kCube ? dice.below(3) : 1] = dice.coin() ? 1.125 : -0.125;
    rays.push_back(
        through({alone(kind, placement), placement, point, along, 0.5 * dice.between(-1, 8)}));
  }
  return rays;
}

// A ray in the plane of a face, or in the side of a cylinder.
std::vector<HardRay> in_face(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const bool tube = n % 4 == 1;
    const PrimitiveKind kind = tube ? PrimitiveKind::cylinder : kCube;
    const Placement placement = any_placement(dice, n);
    const int axis = tube ? 1 : dice.below(3), face = dice.below(2);
    glm::dvec3 along = dice.integers(3), point = inner_point(dice, kind);
    along[axis] = 0;
    point[axis] = face;
    if (along == glm::dvec3(0)) along[(axis + 1) % 3] = 1;
    if (tube && n % 8 == 1) {  // in the side
      point = {dice.sign(), 0.25, 0};
      along = {0, dice.sign(), 0};
    }
    HardRay ray =
        through({alone(kind, placement), placement, point, along, 0.5 * dice.between(-1, 8)});
    ray.direction = with_signed_zeros(dice, ray.direction);
    rays.push_back(ray);
  }
  return rays;
}

// In the plane that two cubes share, side by side or one on the other: the open
// sets do not hold it, whatever the operation; a third cube may.
std::vector<HardRay> in_shared_plane(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 90; ++n) {
    const Placement placement = any_placement(dice, n);
    const int axis = dice.below(3), face = dice.below(2), other = (axis + 1) % 3;
    Placement beside = placement;
    beside.translation += placement.linear[axis] * (face ? 1.0 : -1.0);
    if (n % 2) beside.translation += placement.linear[other] * 0.5;
    SceneBuilder build;
    const auto a = build.primitive(kCube, placement, 1, 1),
               b = build.primitive(kCube, beside, 1, 2);
    auto solid = build.combine(kOperations[static_cast<std::size_t>(dice.below(3))], a, b);
    if (n % 3 == 0) {
      Placement third = placement;
      third.translation += placement.linear[axis] * (face ? 0.5 : -0.5);
      solid = build.combine(dice.coin() ? Operation::union_of : Operation::difference, solid,
                            build.primitive(kCube, third, 1, 0));
    }
    glm::dvec3 along = dice.integers(3), point = inner_point(dice, kCube);
    along[axis] = 0;
    point[axis] = face;
    if (along == glm::dvec3(0)) along[other] = 1;
    const auto scene = std::make_shared<const Scene>(build.finish(solid));
    HardRay ray = through({scene, placement, point, along, 0.5 * dice.between(-1, 8)});
    ray.direction = with_signed_zeros(dice, ray.direction);
    rays.push_back(ray);
  }
  return rays;
}

// Out of a face's plane by 10^-k: inside over a long way, or not at all.
std::vector<HardRay> nearly_in_face(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 1; k <= 15; ++k)
    for (int variant = 0; variant < 6; ++variant) {
      const Placement placement = any_placement(dice, variant);
      const int axis = dice.below(3);
      glm::dvec3 along = dice.integers(3), point = inner_point(dice, kCube);
      along[axis] = variant < 3 ? 0 : ten(-k) * dice.sign();
      if (along[(axis + 1) % 3] == 0 && along[(axis + 2) % 3] == 0) along[(axis + 1) % 3] = 1;
      point[axis] = dice.below(2) + (variant < 3 ? ten(-k) * dice.sign() : 0.0);
      rays.push_back(
          through({alone(kCube, placement), placement, point, along, double(dice.between(0, 4))}));
    }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_flat() {
  return {{"cube_edge", edge},
          {"cube_corner", corner},
          {"parallel_axis", parallel_axis},
          {"parallel_face", parallel_face},
          {"in_face", in_face},
          {"in_shared_plane", in_shared_plane},
          {"nearly_in_face", nearly_in_face}};
}

}  // namespace sir::test
