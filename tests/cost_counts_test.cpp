// The costs of the algorithm of Roth are those of his formula (thesis 2.5), and
// every cure leaves less of them.
#include <gtest/gtest.h>

#include <optional>

#include "bench/scenes.h"
#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/render.h"

namespace sir {
namespace {

// Rays of one kind only, that Roth's example has: primary.
RenderOptions primary_rays(ImageSize size, Engine engine) {
  RenderOptions options;
  options.size = size;
  options.trace.engine = engine;
  options.trace.depth_limit = 1;
  options.trace.allowed_effects.shadow = false;
  return options;
}

// A union of cubes and cones, as many of each: four surfaces a primitive, which
// is the average that thesis 2.5 assumes.
Scene cubes_and_cones(int pairs) {
  std::mt19937_64 random(25);
  test::SceneBuilder builder;
  std::optional<test::SceneBuilder::Id> root;
  for (int i = 0; i < 2 * pairs; ++i) {
    const auto kind = i % 2 ? PrimitiveKind::cone : PrimitiveKind::cube;
    const auto id = builder.primitive(kind, test::random_placement(random, 0.2, false));
    root = root ? builder.combine(Operation::union_of, *root, id) : id;
  }
  Scene scene = builder.finish(*root);
  scene.camera = {{2.4, 2.4}, {0, 0, 0}, {0, 0, -1}, 4, {0, 1, 0}, false, 4, false};
  scene.lighting.lights = {{{3, 5, 6}, glm::dvec3(1)}};
  return scene;
}

TEST(CostCounts, RothsExample) {
  // 300 primitives; CUSTO 1 to 4 are for 500x500, and a hundredth of them for 50x50. Thesis 2.5
  // rounds 599 calls to 600 and 299 combinations to 300: "600 (in truth 599)".
  const CostCounts costs =
      render(cubes_and_cones(150), primary_rays({50, 50}, Engine::roth)).counts.costs;
  EXPECT_EQ(costs.calls, 599u * 2'500u);
  EXPECT_EQ(costs.combinations, 299u * 2'500u);
  EXPECT_EQ(costs.transformations(), 75'000'000u / 100u);
  EXPECT_EQ(costs.intersection_tests(), 300'000'000u / 100u);
  EXPECT_EQ(costs.envelopes, 0u);
}

TEST(CostCounts, EachPrimitiveHasItsSurfaces) {
  test::SceneBuilder builder;
  const auto cube = builder.cube({0, 0, 0}, {1, 1, 1});
  const auto sphere = builder.sphere({5, 0, 0}, 1);
  const auto cone = builder.primitive(PrimitiveKind::cone);
  const auto cylinder = builder.primitive(PrimitiveKind::cylinder);
  const auto left = builder.combine(Operation::difference, cube, sphere);
  const auto right = builder.combine(Operation::intersection, cone, cylinder);
  Scene scene = builder.finish(builder.combine(Operation::union_of, left, right));
  const auto rays = render(scene, primary_rays({8, 6}, Engine::roth)).counts;
  EXPECT_EQ(rays.primary, 48u);
  EXPECT_EQ(rays.costs.calls, 48u * 7u);
  EXPECT_EQ(rays.costs.combinations, 48u * 3u);
  EXPECT_EQ(rays.costs.transformations(), 48u * 4u);
  EXPECT_EQ(rays.costs.intersection_tests(), 48u * (6 + 1 + 2 + 3));
}

TEST(CostCounts, TheyRecurForEveryRay) {
  const Scene scene = cubes_and_cones(10);
  RenderOptions options = primary_rays({20, 20}, Engine::roth);
  options.trace.allowed_effects.shadow = true;
  const RayCounts rays = render(scene, options).counts;
  ASSERT_GT(rays.shadow, 0u);
  EXPECT_EQ(rays.costs.calls, 39 * (rays.primary + rays.shadow));
  EXPECT_EQ(rays.costs.combinations, 19 * (rays.primary + rays.shadow));
  // A shadow ray is not tested against the convex primitive that it leaves.
  EXPECT_EQ(rays.costs.transformations(), 20 * rays.primary + 19 * rays.shadow);
}

TEST(CostCounts, EnvelopesLeaveLess) {
  for (const bool chain : {false, true}) {
    const Scene scene = bench::made_scene({.primitives = 300, .chain = chain});
    const auto of = [&](Engine engine) { return render(scene, primary_rays({50, 50}, engine)); };
    const RenderResult plain = of(Engine::roth), envelopes = of(Engine::envelopes),
                       gates = of(Engine::gates);
    EXPECT_EQ(plain.planes, envelopes.planes);
    EXPECT_EQ(plain.planes, gates.planes);
    const CostCounts &a = plain.counts.costs, &b = envelopes.counts.costs, &c = gates.counts.costs;
    EXPECT_GT(a.calls, b.calls);
    EXPECT_GT(a.combinations, b.combinations);
    EXPECT_GT(b.combinations, c.combinations);
    // A balanced tree, halved by place, is as good a hierarchy as any; a chain is none.
    if (chain) {
      EXPECT_GT(b.calls, 4 * c.calls);
      EXPECT_GT(b.envelopes, 4 * c.envelopes);
    }
    EXPECT_GT(a.intersection_tests(), 10 * b.intersection_tests());
    EXPECT_GT(c.envelopes, 0u);
  }
}

// One part in one node. Of the image's squares of 16 pixels' side the first is listed to
// meet it: all its rays test the part's box, and those that meet that, the primitive,
// which fills it.
TEST(CostCounts, APacketsRaysCountOneByOne) {
  test::SceneBuilder builder;
  Scene scene = builder.finish(builder.cube({-1, -1, -1}, {1, 1, 1}));
  scene.camera = {{4, 4}, {0, 0, 0}, {0, 0, -1}, 4, {0, 1, 0}, true, 4, false};
  scene.lighting.background = {1, 0, 0};
  RenderOptions options = primary_rays({20, 20}, Engine::gates);
  const RayCounts rays = render(scene, options).counts;
  EXPECT_EQ(rays.packets, 25u);
  EXPECT_EQ(rays.doubtful, 0u);
  EXPECT_EQ(rays.spans, 100u);
  EXPECT_EQ(rays.costs.primitives, (std::array<std::uint64_t, 4>{100, 0, 0, 0}));
  EXPECT_EQ(rays.costs.envelopes, 256u + 2 + 3 * 1);  // and for the lists of four squares
  EXPECT_EQ(rays.costs.calls, 100u);
  EXPECT_EQ(rays.costs.combinations, 0u);
  options.trace.packets = false;
  EXPECT_EQ(render(scene, options).counts.packets, 0u);
}

// Packets see what single rays see, and a little more: they go together.
TEST(CostCounts, PacketsCostAboutAsMuchAsTheirRays) {
  const Scene scene = bench::made_scene({.primitives = 300});
  RenderOptions options = primary_rays({100, 100}, Engine::gates);
  const RayCounts together = render(scene, options).counts;
  options.trace.packets = false;
  const RayCounts alone = render(scene, options).counts;
  const auto about = [](std::uint64_t a, std::uint64_t b, double most) {
    return double(a) >= 0.9 * double(b) && double(a) <= most * double(b);
  };
  EXPECT_TRUE(about(together.costs.transformations(), alone.costs.transformations(), 1.2));
  EXPECT_LT(together.costs.envelopes, alone.costs.envelopes);  // of a tile's list only
  EXPECT_TRUE(about(together.spans, alone.spans, 1.2));
  EXPECT_LE(together.exact, alone.exact);
}

TEST(CostCounts, DoNotDependOnTheNumberOfThreads) {
  const Scene scene = bench::made_scene({.primitives = 100});
  for (const auto engine : {Engine::gates, Engine::roth, Engine::envelopes}) {
    RenderOptions options;
    options.size = {70, 70};
    options.trace.engine = engine;
    options.threads = 1;
    const CostCounts one = render(scene, options).counts.costs;
    options.threads = 3;
    const CostCounts three = render(scene, options).counts.costs;
    EXPECT_EQ(one, three);
  }
}

TEST(CostCounts, EnvelopesOnTheTreeGiveRothsImages) {
  RenderOptions options;
  options.size = {48, 36};
  for (std::uint64_t seed = 0; seed < test::cases(40); ++seed) {
    const Scene scene = test::random_scene(seed, 3 + static_cast<int>(seed) % 12, seed % 3 == 0);
    for (const auto precision : {Precision::double_, Precision::float_, Precision::long_double}) {
      options.precision = precision;
      options.trace.engine = Engine::envelopes;
      const auto cured = render(scene, options);
      options.trace.engine = Engine::roth;
      ASSERT_EQ(cured.planes, render(scene, options).planes) << seed;
    }
  }
}

}  // namespace
}  // namespace sir
