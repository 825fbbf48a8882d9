// Glass that must not be seen, and glass that must give numbers: each picture is
// compared byte for byte with one that has to look the same.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene_builder.h"
#include "tracer/render.h"

namespace sir {
namespace {

using test::SceneBuilder;

// Scenes of glass before a matt cube and ball, lit by two lights.
struct Glass {
  SceneBuilder build;
  SceneBuilder::Id matter = 0;

  explicit Glass(double index) {
    const auto box = build.cube({-1.5, -1, -1}, {0.25, 0.5, 0}, 1, 500);
    matter = either(box, build.sphere({0.75, 0.25, -0.5}, 0.75, 2, 501));
    build.surface(1).first = {glm::dvec3(0.25), {0.75, 0.5, 0.25}, 0, 1, 0, 0};
    build.surface(2).first = {glm::dvec3(0.125), {0.25, 0.75, 0.5}, 0, 1, 0, 0};
    build.surface(3).first = {glm::dvec3(0), glm::dvec3(0), 0, 1, 1, index};
    Scene& scene = build.scene;
    scene.camera = {{4, 3}, {0, 0, 0}, {0.1, -0.2, -1}, 6, {0, 1, 0}, false, 6, false};
    scene.lighting = {{0.1, 0.2, 0.3},
                      glm::dvec3(0.2),
                      {{{2, 5, 6}, glm::dvec3(0.6)}, {{-4, 3, 5}, {0.3, 0.2, 0.4}}}};
  }
  SceneBuilder::Id either(SceneBuilder::Id a, SceneBuilder::Id b) {
    return build.combine(Operation::union_of, a, b);
  }
  SceneBuilder::Id less(SceneBuilder::Id a, SceneBuilder::Id b) {
    return build.combine(Operation::difference, a, b);
  }
  Planes picture(SceneBuilder::Id root, Precision precision, int depth = 12) {
    RenderOptions options;
    options.size = {64, 48};
    options.precision = precision;
    options.trace.depth_limit = depth;
    return render(build.finish(root), options).planes;
  }
};

class GlassImages : public testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(All, GlassImages,
                         testing::Values(Precision::float_, Precision::double_,
                                         Precision::long_double),
                         [](const auto& made) {
                           return made.param == Precision::float_    ? "in_float"
                                  : made.param == Precision::double_ ? "in_double"
                                                                     : "in_long_double";
                         });

TEST_P(GlassImages, OfIndexOneChangeNothing) {
  Glass g(1);
  SceneBuilder& b = g.build;
  const Planes without = g.picture(g.matter, GetParam());
  const auto plate = b.cube({-3, -3, 1}, {3, 3, 1.25}, 3);
  const auto ball = b.sphere({0, 0, 2}, 0.75, 3);
  const auto inner = b.sphere({0, 0, 2}, 0.5, 3);
  const auto clear_of =
      b.primitive(PrimitiveKind::cone, test::placed(glm::dvec3(0.75), {0, 0, 2}), 3);
  const auto column =
      b.primitive(PrimitiveKind::cylinder, test::placed(glm::dvec3(0.5), {-1, -0.5, 2}), 3);
  const struct {
    const char* name;
    SceneBuilder::Id glass;
  } cases[] = {{"plate", plate},
               {"ball", ball},
               {"cone", clear_of},
               {"cylinder", column},
               {"ball in a ball, as a union", g.either(ball, inner)},
               {"hollow ball", g.less(ball, inner)},
               {"ball before a plate", g.either(plate, ball)}};
  for (const auto& c : cases)
    EXPECT_EQ(g.picture(g.either(g.matter, c.glass), GetParam()), without) << c.name;
}

// The matter stands in the glass and shares its back face with it.
TEST_P(GlassImages, OfIndexOneAroundTheMatterChangeNothing) {
  Glass g(1);
  const Planes without = g.picture(g.matter, GetParam());
  const auto block = g.build.cube({-2, -2, -1.5}, {2, 2, 2}, 3);
  // Cut out and set in again: the faces of matter and glass are flush.
  const auto inlaid = g.either(g.less(block, g.matter), g.matter);
  // Of a union the flush faces are no boundary: all of the inside is one.
  const Planes with = g.picture(inlaid, GetParam());
  EXPECT_EQ(with.size, without.size);
  // Whoever looks into a union of glass and matter sees through to its end.
  Glass bare(1);
  EXPECT_EQ(with, g.picture(block, GetParam()));
}

// Glass on both sides of a shared face: no boundary, and so one block.
TEST_P(GlassImages, FlushGlassIsOneBlock) {
  for (const double index : {1.0, 1.5, 0.75}) {
    Glass g(index);
    SceneBuilder& b = g.build;
    const auto left = b.cube({-1.5, -1, 1}, {0, 1, 2}, 3),
               right = b.cube({0, -1, 1}, {1.5, 1, 2}, 3);
    const auto block = b.cube({-1.5, -1, 1}, {1.5, 1, 2}, 3);
    const auto rest = b.cube({0, -1, 1}, {4, 1, 2}, 3);
    const auto picture = [&](SceneBuilder::Id glass) {
      return g.picture(g.either(g.matter, glass), GetParam());
    };
    const Planes whole = picture(block);
    EXPECT_EQ(picture(g.either(left, right)), whole) << index;
    EXPECT_EQ(picture(g.either(right, left)), whole) << index;
    // What is left of the block without its right half is the left half.
    EXPECT_EQ(picture(g.less(block, right)), picture(left)) << index;
    EXPECT_EQ(picture(g.less(block, rest)), picture(left)) << index;
    // A block set into a hole that fits is whole again.
    EXPECT_EQ(picture(g.either(g.less(block, right), right)), whole) << index;
  }
}

// A union has one outer surface: a ball of glass inside a ball of glass is
// not seen, whatever its index.
TEST_P(GlassImages, GlassInsideGlassAsAUnionIsNotSeen) {
  Glass g(1.5);
  g.build.surface(4).first = {glm::dvec3(0), glm::dvec3(0), 0.5, 1, 0.5, 2.5};
  const auto ball = g.build.sphere({0, 0, 2}, 0.75, 3),
             inner = g.build.sphere({0, 0.125, 2}, 0.5, 4);
  EXPECT_EQ(g.picture(g.either(g.matter, g.either(ball, inner)), GetParam()),
            g.picture(g.either(g.matter, ball), GetParam()));
}

// Light goes straight through surfaces, and a kt of 1 takes nothing of it.
TEST_P(GlassImages, ClearGlassBeforeALightTakesNothing) {
  for (const double index : {1.0, 1.5, 1e3, 1e-3}) {
    Glass g(index);
    const Planes without = g.picture(g.matter, GetParam());
    // Above the picture, between the matter and both lights.
    const auto plate = g.build.cube({-9, 3, -9}, {9, 3.0625, 9}, 3);
    EXPECT_EQ(g.picture(g.either(g.matter, plate), GetParam()), without) << index;
  }
}

TEST_P(GlassImages, ExtremeIndicesGiveNumbers) {
  for (const double index : {1e-3, 1e3, 1e-30, 1e30}) {
    Glass g(index);
    const auto ball = g.build.sphere({0, 0, 2}, 0.75, 3);
    const Scene scene = g.build.finish(g.either(g.matter, ball));
    RenderOptions options;
    options.size = {16, 12};
    options.precision = GetParam();
    int refracted_rays = 0, total_reflections = 0;
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 16; ++i)
        for (const TraceNode& node : trace_pixel(scene, options, i, j).log) {
          for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(node.colour[c])) << index;
            ASSERT_TRUE(std::isfinite(node.direction[c])) << index;
            ASSERT_LE(node.colour[c], 2) << index;
          }
          refracted_rays += node.kind == RayKind::refracted;
          total_reflections += node.total_reflection;
        }
    // Into the dense ball everything passes, into the thin one next to nothing.
    EXPECT_GE(index > 1 ? refracted_rays : total_reflections, 10) << index;
  }
}

}  // namespace
}  // namespace sir
