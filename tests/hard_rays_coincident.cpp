// Coincident faces, a solid with itself, touching solids, thin walls and gaps.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

constexpr PrimitiveKind kCube = PrimitiveKind::cube, kSphere = PrimitiveKind::sphere,
                        kCylinder = PrimitiveKind::cylinder;

// p' = outer(inner(p)) in doubles.
Placement after(const Placement& outer, const Placement& inner) {
  return {outer.linear * inner.linear, to_scene(outer, inner.translation)};
}

// Where pairs are put as a whole: at rest, stretched by integers, or turned and
// scaled so that their faces coincide up to rounding only.
Placement whole(Dice& dice, int variant) {
  if (variant % 3 == 0) return {};
  return variant % 3 == 1 ? short_placement(dice) : general_placement(dice);
}

// Two boxes (or a box and a tube) with one or more faces in a common plane:
// halves of units, so that most planes meet.
std::vector<HardRay> coincident(Dice& dice, Operation operation) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const Placement outer = whole(dice, n);
    const auto box = [&] {
      glm::dvec3 low, size;
      for (int i = 0; i < 3; ++i) {
        low[i] = 0.5 * dice.between(0, 1);
        size[i] = 0.5 * dice.between(1, 4);
      }
      return after(outer, placed(size, low));
    };
    const PrimitiveKind right = n % 4 == 3 ? kCylinder : kCube;
    const Part left{kCube, box()};
    const Shared scene = pair_of(dice, operation, left, {right, box()});
    glm::dvec3 point = inner_point(dice, kCube);
    if (n % 2) point[dice.below(3)] = dice.below(2);
    const glm::dvec3 along = n % 5 == 0 ? dice.integers(1) : dice.reals(-1, 1);
    rays.push_back(through({scene, left.placement, point, along, dice.real(2, 6)}));
  }
  return rays;
}
std::vector<HardRay> coincident_union(Dice& dice) { return coincident(dice, Operation::union_of); }
std::vector<HardRay> coincident_difference(Dice& dice) {
  return coincident(dice, Operation::difference);
}
std::vector<HardRay> coincident_intersection(Dice& dice) {
  return coincident(dice, Operation::intersection);
}

// The same solid by another matrix: axes permuted, turned about an axis, turned
// upside down, or the same one again.
Placement same_again(Dice& dice, PrimitiveKind kind, const Placement& placement) {
  Placement inner;
  switch (kind) {
    case PrimitiveKind::cube: {
      const int first = dice.below(3), step = dice.between(1, 2);
      inner.linear = glm::dmat3(0);
      for (int i = 0; i < 3; ++i) {
        const int to = (first + i * step) % 3;
        const bool turned = dice.coin();
        inner.linear[i][to] = turned ? -1 : 1;
        if (turned) inner.translation[to] = 1;
      }
      break;
    }
    case PrimitiveKind::sphere: inner.linear = rotation(dice); break;
    case PrimitiveKind::cone:
    case PrimitiveKind::cylinder: {
      const Quadruple q = triple(dice);
      const double c = q.numerator.x / q.denominator, s = q.numerator.z / q.denominator;
      inner.linear = glm::dmat3({c, 0, s}, {0, 1, 0}, {-s, 0, c});
      if (kind == kCylinder && dice.coin()) {
        inner.linear[1].y = -1;
        inner.translation.y = 1;
      }
      break;
    }
  }
  return after(placement, inner);
}

std::vector<HardRay> same_solid(Dice& dice, Operation operation) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Placement one = n % 3 == 2 ? aligned_placement(dice) : whole(dice, n + 1);
    const Placement other = n % 2 ? one : same_again(dice, kind, one);
    const Shared scene = pair_of(dice, operation, {kind, one}, {kind, other});
    rays.push_back(
        through({scene, one, inner_point(dice, kind), dice.reals(-1, 1), dice.real(-0.2, 8)}));
  }
  return rays;
}
std::vector<HardRay> self_union(Dice& dice) { return same_solid(dice, Operation::union_of); }
std::vector<HardRay> self_difference(Dice& dice) { return same_solid(dice, Operation::difference); }
std::vector<HardRay> self_intersection(Dice& dice) {
  return same_solid(dice, Operation::intersection);
}

// Cubes that share a face, an edge or a corner; aimed at what they share.
std::vector<HardRay> touching(Dice& dice, int shared) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 72; ++n) {
    const Placement outer = whole(dice, n);
    glm::dvec3 point = inner_point(dice, kCube), step(0);
    const int first = dice.below(3);
    for (int i = 0; i < shared; ++i) {
      const int axis = (first + i) % 3;
      step[axis] = dice.sign();
      point[axis] = step[axis] > 0 ? 1 : 0;
    }
    const Placement beside = after(outer, placed(glm::dvec3(1), step));
    const Shared scene = pair_of(dice, kOperations[static_cast<std::size_t>(n % 3)], {kCube, outer},
                                 {kCube, beside});
    // Through it from one into the other, or between them.
    glm::dvec3 along = n % 2 ? dice.integers(3) : step + 0.25 * dice.integers(2);
    if (along == glm::dvec3(0)) along = step;
    rays.push_back(through({scene, outer, point, along, 0.5 * dice.between(-1, 8)}));
  }
  return rays;
}
std::vector<HardRay> touching_face(Dice& dice) { return touching(dice, 1); }
std::vector<HardRay> touching_edge(Dice& dice) { return touching(dice, 2); }
std::vector<HardRay> touching_point(Dice& dice) { return touching(dice, 3); }

// A ball that touches another, a plate or a tube, in one point.
std::vector<HardRay> touching_round(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 72; ++n) {
    const Placement outer = whole(dice, n);
    const Quadruple q = quadruple(dice);
    Part other;
    glm::dvec3 point;
    if (n % 3 == 0) {
      point = q.numerator;
      other = {kSphere, placed(glm::dvec3(2 * q.denominator), 3.0 * q.numerator)};
    } else {
      point = {0, q.denominator, 0};
      other = {n % 3 == 1 ? kCube : kCylinder, placed(glm::dvec3(8), {-4, q.denominator, -4})};
    }
    other.placement = after(outer, other.placement);
    const Part ball{kSphere, after(outer, placed(glm::dvec3(q.denominator), {0, 0, 0}))};
    const Shared scene =
        pair_of(dice, kOperations[static_cast<std::size_t>(dice.below(3))], ball, other);
    const glm::dvec3 along = n % 2 ? q.numerator : dice.integers(4);
    rays.push_back(through({scene, outer, point, along, 0.5 * dice.between(-1, 8)}));
  }
  return rays;
}

// Walls of 10^-k of the size, from within ten sizes: a solid less itself made
// smaller by as much about its middle or moved by it.
std::vector<HardRay> thin_shell(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 3; k <= 13; ++k)
    for (const PrimitiveKind kind : kKinds)
      for (int variant = 0; variant < 3; ++variant) {
        const Placement outer = whole(dice, variant);
        Placement inner = placed(glm::dvec3(1 - ten(-k)), glm::dvec3(0.5 * ten(-k)));
        if (kind == kSphere) inner.translation = {0, 0, 0};
        else if (kind != kCube) inner.translation = {0, 0.25 * ten(-k), 0};
        const Operation operation = variant == 1 ? Operation::intersection : Operation::difference;
        const Shared scene = pair_of(dice, operation, {kind, outer}, {kind, after(outer, inner)});
        rays.push_back(
            through({scene, outer, inner_point(dice, kind), dice.reals(-1, 1), dice.real(0, 8)}));
      }
  return rays;
}

// Two solids apart by 10^-k, and overlapping by as much.
std::vector<HardRay> thin_gap(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 3; k <= 13; ++k)
    for (const int side : {-1, 1})
      for (int variant = 0; variant < 4; ++variant) {
        const Placement outer = whole(dice, variant);
        const double step = 1 + side * ten(-k);
        const PrimitiveKind kind = variant == 3 ? kSphere : kCube;
        const Placement other =
            after(outer, placed(glm::dvec3(1), variant == 3 ? glm::dvec3(0, 2 * step, 0)
                                                            : glm::dvec3(0, step, 0)));
        const Shared scene = pair_of(dice, kOperations[static_cast<std::size_t>(dice.below(3))],
                                     {kind, outer}, {kind, other});
        glm::dvec3 point = inner_point(dice, kCube), along = dice.reals(-1, 1);
        point.y = 1;
        if (variant == 3) {
          point = {0, 1, 0};
          along = along * 0.1 + glm::dvec3(0, 1, 0);
        }
        rays.push_back(through({scene, outer, point, along, dice.real(0, 8)}));
      }
  return rays;
}

// Solids within solids, concentric or with a face flush: a union keeps the outer
// surface only, a difference makes an onion.
std::vector<HardRay> nested(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 96; ++n) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(n % 4)];
    const Placement outer = whole(dice, n);
    const int layers = dice.between(2, 6);
    SceneBuilder build;
    auto solid = build.primitive(kind, outer, 1, 3);
    for (int i = 1; i < layers; ++i) {
      const double size = 1 - 0.125 * i;
      glm::dvec3 move(0);
      if (n % 8 < 4 && kind != kSphere) move.y = 0.5 - 0.5 * size;  // else flush
      const Operation operation = n % 3 == 0 ? Operation::union_of
                                  : i % 2    ? Operation::difference
                                             : Operation::union_of;
      const Placement placement = after(outer, placed(glm::dvec3(size), move));
      solid = build.combine(operation, solid, build.primitive(kind, placement, 1, (3 + 5 * i) % 7));
    }
    const auto scene = std::make_shared<const Scene>(build.finish(solid));
    const glm::dvec3 along = n % 5 ? dice.reals(-1, 1) : dice.integers(2);
    rays.push_back(through({scene, outer, inner_point(dice, kind), along, dice.real(-0.3, 5)}));
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_coincident() {
  return {{"coincident_union", coincident_union},
          {"coincident_difference", coincident_difference},
          {"coincident_intersection", coincident_intersection},
          {"self_union", self_union},
          {"self_difference", self_difference},
          {"self_intersection", self_intersection},
          {"touching_face", touching_face},
          {"touching_edge", touching_edge},
          {"touching_point", touching_point},
          {"touching_round", touching_round},
          {"thin_shell", thin_shell},
          {"thin_gap", thin_gap},
          {"nested", nested}};
}

}  // namespace sir::test
