// Mirrors and glass: colours that can be worked out, depth, cutoff, the log.
#include "tracer/trace.h"

#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"

namespace sir {
namespace {

using test::SceneBuilder;

glm::dvec3 seen(const Scene& scene, const RayCena<double>& ray, const TraceOptions& options = {},
                TraceLog* log = nullptr, RayCounts* counts = nullptr) {
  const Model<double> model(scene, options.allowed_effects);
  Tracer<double> tracer(model, options);
  const auto colour = tracer.radiance(ray, log);
  if (counts) *counts = tracer.counts();
  return colour;
}

void expect_colour(glm::dvec3 got, glm::dvec3 expected, double tolerance = 1e-13) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], tolerance) << "channel " << c;
}

// No lights; what a surface sends back is its ambient term alone.
Surface& make(SceneBuilder& build, std::int64_t number, glm::dvec3 ambient, double ks, double kt,
              double index) {
  Surface& surface = build.surface(number);
  surface.first = {ambient, glm::dvec3(0), ks, 1, kt, index};
  return surface;
}

const RayCena<double> kDown{{{0.1, 5, 0.2}}, {{0, -1, 0}}};

TEST(Trace, BackgroundWhereNothingIsMet) {
  SceneBuilder build;
  build.scene.lighting.background = {0.25, 0.5, 2};
  expect_colour(seen(build.finish(build.sphere({9, 9, 9}, 1)), kDown), {0.25, 0.5, 2});
}

TEST(Trace, MirrorAddsWhatItSees) {
  SceneBuilder build;
  make(build, 1, {0.1, 0.1, 0.1}, 0.5, 0, 0);
  make(build, 2, {0.8, 0.4, 0.2}, 0, 0, 0);
  build.scene.lighting.ambient = glm::dvec3(1);
  const auto floor = build.cube({-1, -1, -1}, {1, 0, 1}, 1);
  const auto ceiling = build.cube({-1, 6, -1}, {1, 7, 1}, 2);
  const Scene scene = build.finish(build.combine(Operation::union_of, floor, ceiling));
  expect_colour(seen(scene, kDown), {0.1 + 0.5 * 0.8, 0.1 + 0.5 * 0.4, 0.1 + 0.5 * 0.2});
}

// Two mirrors face to face: a geometric series cut at the depth limit.
Scene mirror_room(double ks) {
  SceneBuilder build;
  make(build, 1, {0.1, 0.1, 0.1}, ks, 0, 0);
  build.scene.lighting.ambient = glm::dvec3(1);
  build.scene.lighting.background = glm::dvec3(0.7);
  const auto floor = build.cube({-1, -1, -1}, {1, 0, 1}, 1);
  const auto ceiling = build.cube({-1, 6, -1}, {1, 7, 1}, 1);
  return build.finish(build.combine(Operation::union_of, floor, ceiling));
}

TEST(Trace, DepthLimitCutsTheSeries) {
  const double ks = 0.5;
  for (const int depth : {1, 2, 5, 100, 20000}) {
    TraceOptions options;
    options.depth_limit = depth;
    double sum = 0, weight = 1;
    for (int k = 0; k < depth; ++k, weight *= ks) sum += 0.1 * weight;
    RayCounts counts;
    expect_colour(seen(mirror_room(ks), kDown, options, nullptr, &counts), glm::dvec3(sum));
    EXPECT_EQ(counts.reflected, static_cast<std::uint64_t>(depth - 1));
    options.past_limit = PastLimit::background;
    expect_colour(seen(mirror_room(ks), kDown, options), glm::dvec3(sum + weight * 0.7));
  }
}

TEST(Trace, CutoffStopsRaysOfLittleWeight) {
  TraceOptions options;
  options.depth_limit = 50;
  options.cutoff = 0.125;  // 0.5, 0.25 and 0.125 are cast, 0.0625 is not
  RayCounts counts;
  expect_colour(seen(mirror_room(0.5), kDown, options, nullptr, &counts),
                glm::dvec3(0.1 * (1 + 0.5 + 0.25 + 0.125)));
  EXPECT_EQ(counts.reflected, 3u);
}

TEST(Trace, GlassPlateOfIndexOneOnlyFilters) {
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0, 0.5, 1);
  build.scene.lighting.background = {0.8, 0.4, 0.2};
  const Scene scene = build.finish(build.cube({-1, -1, -1}, {1, 0, 1}, 1));
  expect_colour(seen(scene, {{{0.1, 5, 0.2}}, {{0.05, -1, 0.03}}}), {0.2, 0.1, 0.05}, 0);
}

TEST(Trace, GlassSphereBendsByItsIndex) {
  // Into a sphere of index n off its axis: the exit is where geometry says.
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0, 1, 1.5);
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 1, 1));
  TraceLog log;
  seen(scene, {{{0.5, 3, 0}}, {{0, -1, 0}}}, {}, &log);
  ASSERT_EQ(log.size(), 3u);
  EXPECT_TRUE(log[0].entering);
  EXPECT_FALSE(log[1].entering);
  EXPECT_FALSE(log[2].hit);
  EXPECT_EQ(log[1].parent, 0u);
  EXPECT_EQ(log[2].parent, 1u);
  const double in = std::asin(0.5), inside = std::asin(0.5 / 1.5);
  EXPECT_NEAR(log[1].t, 2 * std::cos(inside), 1e-14);  // a chord
  // Turned by twice the difference of the angles, symmetrically, towards the axis.
  const double turn = 2 * (in - inside);
  EXPECT_NEAR(log[2].direction.x, -std::sin(turn), 1e-14);
  EXPECT_NEAR(log[2].direction.y, -std::cos(turn), 1e-14);
}

TEST(Trace, RayFromInsideTakesTheIndexOfWhatItLeaves) {
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0, 1, 1.5);
  const Scene scene = build.finish(build.cube({-9, -9, -9}, {9, 0, 9}, 1));
  TraceLog log;
  seen(scene, {{{0, -1, 0}}, {{0.3, 1, 0}}}, {}, &log);
  ASSERT_EQ(log.size(), 2u);
  const double sine = 1.5 * 0.3 / std::sqrt(1.09);
  EXPECT_NEAR(log[1].direction.x, sine, 1e-14);
}

TEST(Trace, FaceWithoutAnIndexLeavesTheMediumOpen) {
  // From inside glass with a mirror-lined cut: first the mirror, whose ir is
  // 0, then out through the glass, which alone can tell the index.
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0, 1, 1.5);
  make(build, 2, {0, 0, 0}, 0.5, 0, 0);
  const auto glass = build.cube({-9, -9, -9}, {9, 0, 9}, 1);
  const auto cut = build.cube({-9, -9, -9}, {9, -4, 9}, 2);
  TraceLog log;
  seen(build.finish(build.combine(Operation::difference, glass, cut)),
       {{{0, -1, 0}}, {{0.3, -1, 0}}}, {}, &log);
  ASSERT_EQ(log.size(), 3u);
  EXPECT_EQ(log[1].kind, RayKind::reflected);
  EXPECT_EQ(log[2].kind, RayKind::refracted);
  EXPECT_NEAR(log[2].direction.x, 1.5 * 0.3 / std::sqrt(1.09), 1e-14);
}

TEST(Trace, TotalReflectionJoinsTheMirroredRay) {
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0.25, 0.5, 1.5);
  build.scene.lighting.background = glm::dvec3(1);
  const Scene scene = build.finish(build.cube({-9, -9, -9}, {9, 0, 9}, 1));
  TraceOptions options;
  options.depth_limit = 2;
  TraceLog log;
  seen(scene, {{{0, -1, 0}}, {{1, 0.5, 0}}}, options, &log);
  ASSERT_EQ(log.size(), 2u);  // no refracted ray
  EXPECT_TRUE(log[0].total_reflection);
  EXPECT_EQ(log[1].kind, RayKind::reflected);
  EXPECT_DOUBLE_EQ(log[1].factor, 0.75);
  // Without reflection as an effect the transmitted share alone is mirrored.
  options.allowed_effects.reflection = false;
  log.clear();
  seen(scene, {{{0, -1, 0}}, {{1, 0.5, 0}}}, options, &log);
  ASSERT_EQ(log.size(), 2u);
  EXPECT_DOUBLE_EQ(log[1].factor, 0.5);
}

TEST(Trace, RefractionSwitchedOffIsNoTotalReflection) {
  SceneBuilder build;
  make(build, 1, {0, 0, 0}, 0.25, 0.5, 1.5);
  const Scene scene = build.finish(build.cube({-9, -9, -9}, {9, 0, 9}, 1));
  TraceOptions options;
  options.allowed_effects.refraction = false;
  TraceLog log;
  seen(scene, kDown, options, &log);
  ASSERT_EQ(log.size(), 2u);
  EXPECT_FALSE(log[0].total_reflection);
  EXPECT_DOUBLE_EQ(log[1].factor, 0.25);
}

TEST(Trace, LogAddsUp) {
  int nodes = 0;
  for (std::uint64_t seed = 0; seed < test::cases(40); ++seed) {
    const Scene scene = test::random_scene(seed, 5, false);
    const Model<double> model(scene, {});
    TraceLog log;
    Tracer<double> tracer(model, {});
    const int column = 16 + static_cast<int>(seed) % 9;
    const auto colour = tracer.radiance(model.camera.primary_ray(column, 15, {41, 31}), &log);
    ASSERT_FALSE(log.empty());
    expect_colour(log[0].colour, colour, 0);
    for (std::size_t n = 0; n < log.size(); ++n) {
      if (!log[n].hit) continue;
      glm::dvec3 sum = log[n].local;
      for (const TraceNode& child : log)
        if (child.parent == n) sum += child.factor * child.colour;
      expect_colour(log[n].colour, sum, 1e-12);
      ++nodes;
    }
    EXPECT_NE(describe(log, scene).find("primary ray"), std::string::npos);
  }
  EXPECT_GT(nodes, 40);
}

}  // namespace
}  // namespace sir
