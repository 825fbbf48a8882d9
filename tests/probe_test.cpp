#include "tracer/probe.h"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "tests/scene_builder.h"

namespace sir {
namespace {

TEST(Probe, NamesNumbersOfTheFiles) {
  test::SceneBuilder build;
  const auto a =
      build.primitive(PrimitiveKind::cylinder, test::placed({1, 2, 1}, {0, 0, 0}), 70, 700);
  build.scene.tree.nodes[a].surfaces = {70, 71, 72};
  build.surface(71);
  build.surface(72);
  const auto prober = make_prober(build.finish(a), Precision::double_);
  const auto& down = prober->hits({0.25, 5, 0}, {0, -1, 0});
  ASSERT_EQ(down.size(), 2u);
  EXPECT_EQ(down[0].node, 700);
  EXPECT_EQ(down[0].face, 1);
  EXPECT_EQ(down[0].surface, 71);
  EXPECT_EQ(down[0].t, 3);
  EXPECT_EQ(down[1].surface, 70);
  const auto& across = prober->hits({-5, 1, 0}, {1, 0, 0});
  ASSERT_EQ(across.size(), 2u);
  EXPECT_EQ(across[0].surface, 72);
}

TEST(Probe, FloatRunsInFloat) {
  test::SceneBuilder build;
  const auto prober =
      make_prober(build.finish(build.sphere({0, 0, 0}, 1.0 / 3)), Precision::float_);
  const auto& hits = prober->hits({0, 0, 2}, {0, 0, -1});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].t, static_cast<double>(static_cast<float>(hits[0].t)));
  EXPECT_NEAR(hits[0].t, 5.0 / 3, 1e-6);
}

TEST(Probe, WhatUnderflowsIsNotTakenForParallel) {
  // y moves by 1e-170 of 1e-170 a step of x by 1e170 long; so does its float twin.
  for (const auto& [big, small, precision] : {std::tuple(1e170, 1e-170, Precision::double_),
                                              std::tuple(1e25, 1e-22, Precision::float_)}) {
    test::SceneBuilder build;
    const Scene scene = build.finish(
        build.primitive(PrimitiveKind::cube, test::placed({big, small, 1}, glm::dvec3(0))));
    const auto hits = make_prober(scene, precision)->hits({-big / 10, small / 2, 0.5}, {1, 0, 0});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].t / big, 0.1, 1e-6);
    EXPECT_NEAR(hits[1].t / big, 1.1, 1e-6);
  }
}

TEST(Probe, ManyCopiesOfOneSolidAreOne) {
  test::SceneBuilder build;
  auto all = build.sphere({0, 0, 0}, 1);
  for (int n = 1; n < 5000; ++n)
    all = build.combine(n % 2 ? Operation::union_of : Operation::intersection, all,
                        build.sphere({0, 0, 0}, 1));
  const auto prober = make_prober(build.finish(all), Precision::double_);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-0.5, 0.5);
  for (int n = 0; n < 20; ++n) {
    const auto& hits = prober->hits({any(random), any(random), 9}, {any(random) / 20, 0, -1});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].node, 0);
  }
}

}  // namespace
}  // namespace sir
