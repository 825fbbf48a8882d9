#include "tracer/probe.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace sir
