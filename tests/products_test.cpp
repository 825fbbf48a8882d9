// The solid as a union of products holds the points that its tree holds.
#include "tracer/products.h"

#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/solid.h"

namespace sir {
namespace {

using test::SceneBuilder;

// Whether each primitive holds a point. On a grid's midpoints the arithmetic is exact.
std::vector<bool> holding(const Solid<double>& solid, glm::dvec3 point) {
  std::vector<bool> inside;
  for (const Leaf<double>& leaf : solid.leaves) {
    const glm::dvec3 p = leaf.placement.unapply(PointCena<double>{point}).v;
    const double round = p.x * p.x + p.z * p.z;
    const bool high = p.y > 0 && p.y < 1;
    switch (leaf.kind) {
      case PrimitiveKind::cube:
        inside.push_back(p.x > 0 && p.x < 1 && high && p.z > 0 && p.z < 1);
        break;
      case PrimitiveKind::sphere: inside.push_back(round + p.y * p.y < 1); break;
      case PrimitiveKind::cone: inside.push_back(high && round < (1 - p.y) * (1 - p.y)); break;
      case PrimitiveKind::cylinder: inside.push_back(high && round < 1); break;
    }
  }
  return inside;
}

bool by_tree(const Solid<double>& solid, const std::vector<bool>& inside) {
  std::vector<bool> stack;
  for (const PolishStep& step : solid.polish) {
    if (step.is_leaf) {
      stack.push_back(inside[step.leaf]);
      continue;
    }
    const bool right = stack.back();
    stack.pop_back();
    const bool left = stack.back();
    stack.back() = step.operation == Operation::union_of       ? left || right
                   : step.operation == Operation::intersection ? left && right
                                                               : left && !right;
  }
  return stack.back();
}

bool within(const Bounds<double>& box, glm::dvec3 p) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < box.low[axis] || p[axis] > box.high[axis]) return false;
  return true;
}

bool by_products(const Products<double>& products, const std::vector<bool>& inside,
                 glm::dvec3 point) {
  bool any = false;
  for (std::size_t i = 0; i < products.list.size(); ++i) {
    const ProductRange& product = products.list[i];
    bool all = true;
    for (std::uint32_t k = 0; k < product.positives + product.negatives; ++k)
      all = all && inside[products.leaves[product.first + k]] == (k < product.positives);
    any = any || all;
    if (!all) continue;
    for (std::size_t at = 0; at < products.hierarchy.order().size(); ++at) {
      if (products.hierarchy.order()[at] != i) continue;
      EXPECT_TRUE(within(products.hierarchy.boxes()[at], point)) << "outside of its envelope";
    }
  }
  return any;
}

struct Tally {
  int complete = 0, inside = 0, outside = 0;
};

void compare(const Scene& scene, std::uint64_t seed, bool aligned, Tally& tally) {
  const auto solid = build_solid<double>(scene);
  if (!solid.products.complete) return;
  ++tally.complete;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1.8, 1.8);
  for (int n = 0; n < 150; ++n) {
    glm::dvec3 point(any(random), any(random), any(random));
    if (aligned) point = glm::round(point * 8.0) / 8.0 + 0.0625;
    const auto inside = holding(solid, point);
    const bool expected = by_tree(solid, inside);
    ASSERT_EQ(by_products(solid.products, inside, point), expected) << "seed " << seed;
    ++(expected ? tally.inside : tally.outside);
  }
}

// All operations alike, so that complements of complements are common.
Scene mixed_tree(std::uint64_t seed, int leaves, bool aligned, bool chain) {
  std::mt19937_64 random(seed);
  SceneBuilder build;
  const auto below = [&](unsigned count) { return static_cast<int>(random() % count); };
  std::vector<SceneBuilder::Id> open;
  for (int i = 0; i < leaves; ++i) {
    Placement placement = test::random_placement(random, 0.9, below(2) == 0);
    if (aligned)
      placement = test::placed(glm::dvec3(1 + below(2), 1 + below(2), 1 + below(2)) * 0.5,
                               glm::dvec3(below(4), below(4), below(4)) * 0.5 - 1.0);
    open.push_back(build.primitive(static_cast<PrimitiveKind>(below(4)), placement));
  }
  auto top = open.back();
  open.pop_back();
  while (!open.empty()) {
    const auto operation = static_cast<Operation>(below(3));
    if (chain || open.size() == 1) {
      const auto next = open.back();
      open.pop_back();
      top = below(4) ? build.combine(operation, top, next) : build.combine(operation, next, top);
    } else {
      const auto at = static_cast<std::size_t>(below(static_cast<unsigned>(open.size())));
      open[at] = build.combine(operation, open[at], top);
      top = open.back();
      open.pop_back();
    }
  }
  return build.finish(top);
}

TEST(Products, HoldThePointsOfTheTree) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(400); ++seed)
    for (const bool aligned : {false, true}) {
      const int leaves = 1 + static_cast<int>(seed) % 30;
      ASSERT_NO_FATAL_FAILURE(
          compare(test::random_scene(seed, leaves, aligned), seed, aligned, tally));
      ASSERT_NO_FATAL_FAILURE(
          compare(mixed_tree(seed, leaves, aligned, seed % 2), seed, aligned, tally));
    }
  EXPECT_GT(tally.complete, 1500);
  EXPECT_GT(tally.inside, 5000);
  EXPECT_GT(tally.outside, 50000);
}

TEST(Products, ACutIsFeltOnlyWhereItIs) {
  SceneBuilder build;
  auto root = build.cube({0, 0, 0}, {1, 1, 1});
  for (int i = 1; i < 10; ++i)
    root = build.combine(Operation::union_of, root, build.cube({2 * i, 0, 0}, {2 * i + 1, 1, 1}));
  root = build.combine(Operation::difference, root, build.cube({1.5, 0.5, 0.5}, {4.5, 2, 2}));
  const auto products = build_solid<double>(build.finish(root)).products;
  ASSERT_TRUE(products.complete);
  ASSERT_EQ(products.list.size(), 10u);
  std::uint32_t cut = 0;
  for (const ProductRange& product : products.list) {
    EXPECT_EQ(product.positives, 1u);
    cut += product.negatives;
  }
  EXPECT_EQ(cut, 2u);
}

TEST(Products, WhatIsEmptyHasNone) {
  SceneBuilder build;
  const auto apart = build.combine(Operation::intersection, build.cube({0, 0, 0}, {1, 1, 1}),
                                   build.cube({3, 0, 0}, {4, 1, 1}));
  const auto products = build_solid<double>(build.finish(apart)).products;
  EXPECT_TRUE(products.complete);
  EXPECT_TRUE(products.list.empty());
  EXPECT_TRUE(products.hierarchy.nodes().empty());
}

// Small cubes on a line, so that envelopes tell them apart.
SceneBuilder::Id small(SceneBuilder& build, int i) {
  return build.primitive(PrimitiveKind::cube, test::placed(glm::dvec3(0.5), {double(i), 0, 0}));
}

TEST(Products, ChainsOfAHundredThousand) {
  for (const bool alternating : {false, true}) {
    SceneBuilder build;
    auto root = small(build, 0);
    for (int i = 1; i < 100'000; ++i)
      root = build.combine(alternating && i % 2 ? Operation::difference : Operation::union_of, root,
                           small(build, i));
    const auto products = build_solid<double>(build.finish(root)).products;
    ASSERT_TRUE(products.complete);
    EXPECT_EQ(products.list.size(), alternating ? 50'000u : 100'000u);
    EXPECT_EQ(products.leaves.size(), products.list.size());
  }
}

TEST(Products, AThousandCutsOfThirtyThousand) {
  SceneBuilder build;
  auto root = small(build, 0);
  for (int i = 1; i < 30'000; ++i) root = build.combine(Operation::union_of, root, small(build, i));
  auto cutters = build.cube({0.25, -1, -1}, {1.25, 1, 1});
  for (int i = 1; i < 1000; ++i)
    cutters = build.combine(Operation::union_of, cutters,
                            build.cube({30 * i + 0.25, -1, -1}, {30 * i + 1.25, 1, 1}));
  root = build.combine(Operation::difference, root, cutters);
  const auto products = build_solid<double>(build.finish(root)).products;
  ASSERT_TRUE(products.complete);
  EXPECT_EQ(products.list.size(), 30'000u);
  EXPECT_EQ(products.leaves.size(), 32'000u);
}

// (A1+B1)*(A2+B2)*... has 2^n parts that envelopes do not tell apart.
TEST(Products, GiveUpWhereThereAreTooMany) {
  for (const auto inner : {Operation::union_of, Operation::intersection}) {
    SceneBuilder build;
    auto root = build.cube({0, 0, 0}, {1, 1, 1});
    for (int i = 0; i < 200; ++i)
      root = build.combine(
          inner == Operation::union_of ? Operation::intersection : Operation::difference, root,
          build.combine(inner, build.cube({0, 0, 0}, {1, 1, 1}),
                        build.cube({0.1, 0, 0}, {1, 1, 1})));
    const auto products = build_solid<double>(build.finish(root)).products;
    EXPECT_FALSE(products.complete);
    EXPECT_TRUE(products.list.empty());
    EXPECT_TRUE(products.leaves.empty());
  }
}

}  // namespace
}  // namespace sir
