// Compositions: chains hundreds deep, nested ones, random trees.
#include "tests/hard_rays_dice.h"

#include <cmath>

namespace sir::test {
namespace {

using Id = SceneBuilder::Id;

std::size_t pick(Dice& dice, std::size_t below) {
  return static_cast<std::size_t>(dice.below(static_cast<int>(below)));
}

// 0 ... count-1 in random order: node numbers that tell nothing.
std::vector<std::int64_t> shuffled(Dice& dice, int count) {
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(i);
  for (std::size_t i = numbers.size(); i > 1; --i)
    std::swap(numbers[i - 1], numbers[pick(dice, i)]);
  return numbers;
}

// A small solid somewhere in the beam x = 0 ... 10, |y|, |z| < 1.
Placement in_beam(Dice& dice, bool on_grid) {
  if (on_grid) {
    const double size = 0.25 * dice.between(1, 4);
    const double x = 0.25 * dice.between(0, 40), y = 0.25 * dice.between(-4, 2);
    return placed(glm::dvec3(size), {x, y, 0.25 * dice.between(-4, 2)});
  }
  Placement placement = general_placement(dice, 0.5);
  placement.translation += glm::dvec3(dice.real(0, 10), 0, 0);
  return placement;
}

HardRay along_beam(Dice& dice, const Shared& scene, bool on_grid) {
  if (on_grid) {
    const glm::dvec3 at{0.125 * dice.between(0, 80), 0.125 * dice.between(-6, 6),
                        0.125 * dice.between(-6, 6)};
    return through({scene, at, dice.coin() ? glm::dvec3(1, 0, 0) : dice.integers(2), 6});
  }
  const glm::dvec3 at{-dice.real(0, 3), dice.real(-0.5, 0.5), dice.real(-0.5, 0.5)};
  return {scene, at, glm::dvec3{1, dice.real(-0.05, 0.05), dice.real(-0.05, 0.05)}};
}

// A chain of `links` of one operation, the long side left or right.
Shared chain(Dice& dice, Operation operation, int links, bool right_deep, bool on_grid) {
  SceneBuilder build;
  const std::vector<std::int64_t> numbers = shuffled(dice, links + 1);
  const Part whole{PrimitiveKind::cube, placed({12, 4, 4}, {-1, -2, -2})};
  Id solid = 0;
  for (int i = 0; i <= links; ++i) {
    PrimitiveKind kind = on_grid && dice.coin() ? PrimitiveKind::cube : kKinds[pick(dice, 4)];
    Placement placement = in_beam(dice, on_grid);
    if (operation == Operation::intersection) {
      // Large ones that share the beam's middle; half of them end alike.
      kind = dice.coin() ? PrimitiveKind::cube : PrimitiveKind::sphere;
      const double reach = on_grid ? 0.25 * dice.between(16, 24) : dice.real(4, 6);
      placement = kind == PrimitiveKind::cube
                      ? placed(glm::dvec3(2 * reach), glm::dvec3(5 - reach, -reach, -reach))
                      : placed(glm::dvec3(reach), glm::dvec3(5, 0, 0));
    } else if (operation == Operation::difference && i == (right_deep ? links : 0)) {
      kind = whole.kind;
      placement = whole.placement;
    }
    const Id next = build.primitive(kind, placement, 1, numbers[static_cast<std::size_t>(i)]);
    if (i == 0) solid = next;
    else if (right_deep) solid = build.combine(operation, next, solid);
    else solid = build.combine(operation, solid, next);
  }
  return std::make_shared<const Scene>(build.finish(solid));
}

std::vector<HardRay> chains(Dice& dice, Operation operation) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 4; ++n) {
    const bool on_grid = n % 2 == 1;
    const Shared scene = chain(dice, operation, 150 + 100 * n, n >= 2, on_grid);
    for (int i = 0; i < 16; ++i) rays.push_back(along_beam(dice, scene, on_grid));
  }
  return rays;
}
std::vector<HardRay> chain_union(Dice& dice) { return chains(dice, Operation::union_of); }
std::vector<HardRay> chain_difference(Dice& dice) { return chains(dice, Operation::difference); }
std::vector<HardRay> chain_intersection(Dice& dice) {
  return chains(dice, Operation::intersection);
}

// A chain whose operations alternate: A + (B - (C + (D & ...))).
std::vector<HardRay> chain_nested(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 4; ++n) {
    const bool on_grid = n % 2 == 1;
    const int links = 200;
    SceneBuilder build;
    const std::vector<std::int64_t> numbers = shuffled(dice, links + 1);
    Id solid = 0;
    for (int i = 0; i <= links; ++i) {
      const PrimitiveKind kind =
          on_grid && dice.coin() ? PrimitiveKind::cube : kKinds[pick(dice, 4)];
      const Placement small = in_beam(dice, on_grid);
      const Placement large = placed({11, 3, 3}, {-0.5, -1.5, -1.5});
      const Operation operation = kOperations[static_cast<std::size_t>(i % 3)];
      const bool wide = i % 3 != 0;  // something must be left
      const Id next = build.primitive(wide ? PrimitiveKind::cube : kind, wide ? large : small, 1,
                                      numbers[static_cast<std::size_t>(i)]);
      if (i == 0) solid = next;
      else if (n < 2) solid = build.combine(operation, next, solid);
      else solid = build.combine(i % 3 == 2 ? Operation::intersection : operation, solid, next);
    }
    const auto scene = std::make_shared<const Scene>(build.finish(solid));
    for (int i = 0; i < 16; ++i) rays.push_back(along_beam(dice, scene, on_grid));
  }
  return rays;
}

// Any tree: solids are taken at random and combined until one is left.
Shared random_tree(Dice& dice, int leaves, bool on_grid) {
  SceneBuilder build;
  const std::vector<std::int64_t> numbers = shuffled(dice, leaves);
  std::vector<Id> open;
  for (int i = 0; i < leaves; ++i) {
    const PrimitiveKind kind = on_grid && dice.coin() ? PrimitiveKind::cube : kKinds[pick(dice, 4)];
    Placement placement = general_placement(dice);
    placement.translation *= 0.5;
    if (on_grid) {
      glm::dvec3 size, low;
      for (int axis = 0; axis < 3; ++axis) {
        size[axis] = 0.5 * dice.between(1, 3);
        low[axis] = 0.5 * dice.between(-2, 1);
      }
      placement = placed(size, low);
    }
    open.push_back(build.primitive(kind, placement, 1, numbers[static_cast<std::size_t>(i)]));
  }
  const auto take = [&] {
    const std::size_t at = pick(dice, open.size());
    const Id id = open[at];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
    return id;
  };
  while (open.size() > 1) {
    const int roll = dice.below(9);  // mostly unions, or little would be left
    const Id left = take(), right = take();
    open.push_back(build.combine(roll < 6   ? Operation::union_of
                                 : roll < 8 ? Operation::difference
                                            : Operation::intersection,
                                 left, right));
  }
  return std::make_shared<const Scene>(build.finish(open[0]));
}

std::vector<HardRay> random_trees(Dice& dice, bool on_grid) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 60; ++n) {
    const Shared scene = random_tree(dice, dice.between(2, 14), on_grid);
    for (int i = 0; i < 3; ++i) {
      // Through the inside of one of the leaves.
      const CsgNode& node = scene->tree.nodes[pick(dice, scene->tree.nodes.size() / 2 + 1)];
      const glm::dvec3 at = to_scene(node.placement, inner_point(dice, node.kind));
      const glm::dvec3 along = on_grid ? dice.integers(2) : dice.reals(-1, 1);
      rays.push_back(through({scene, at, along, double(dice.between(0, 4))}));
    }
  }
  return rays;
}
std::vector<HardRay> tree_general(Dice& dice) { return random_trees(dice, false); }
std::vector<HardRay> tree_aligned(Dice& dice) { return random_trees(dice, true); }

}  // namespace

std::vector<HardClass> hard_classes_tree() {
  return {{"chain_union", chain_union},
          {"chain_difference", chain_difference},
          {"chain_intersection", chain_intersection},
          {"chain_nested", chain_nested},
          {"tree_general", tree_general},
          {"tree_aligned", tree_aligned}};
}

}  // namespace sir::test
