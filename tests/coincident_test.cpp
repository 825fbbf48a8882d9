// Boundaries that coincide: regularised sets (docs/scene-format.md, .CSG).
#include <gtest/gtest.h>

#include "tests/scene_builder.h"
#include "tracer/probe.h"
#include "tracer/render.h"

namespace sir {
namespace {

using test::SceneBuilder;

struct Found {
  double x;
  bool entering;
  std::int64_t node;
  int face;
  friend bool operator==(const Found&, const Found&) = default;
};
void PrintTo(const Found& f, std::ostream* out) {
  *out << (f.entering ? "in " : "out ") << f.x << " node " << f.node << " face " << f.face;
}

class Coincident : public testing::TestWithParam<Engine> {
 protected:
  std::vector<Found> along_x(SceneBuilder& build, SceneBuilder::Id root, glm::dvec3 d = {1, 0, 0}) {
    const auto prober = make_prober(build.finish(root), Precision::double_, GetParam());
    std::vector<Found> found;
    for (const auto& hit : prober->hits({-1, 0.1, 0.2}, d))
      found.push_back({-1 + hit.t, hit.entering, hit.node, hit.face});
    return found;
  }
};
INSTANTIATE_TEST_SUITE_P(Both, Coincident, testing::Values(Engine::gates, Engine::roth));

constexpr glm::dvec3 kLow(0, -1, -1), kMiddle(1, 1, 1), kHigh(2, 1, 1);

TEST_P(Coincident, SolidWithItself) {
  for (const auto operation : {Operation::union_of, Operation::intersection}) {
    SceneBuilder build;
    const auto a = build.cube(kLow, kMiddle, 1, 8), b = build.cube(kLow, kMiddle, 2, 3);
    EXPECT_EQ(along_x(build, build.combine(operation, a, b)),
              (std::vector<Found>{{0, true, 3, 0}, {1, false, 3, 1}}));
  }
  SceneBuilder build;
  const auto a = build.cube(kLow, kMiddle), b = build.cube(kLow, kMiddle);
  EXPECT_TRUE(along_x(build, build.combine(Operation::difference, a, b)).empty());
}

TEST_P(Coincident, TouchingMembersOfAUnionHaveNoBoundaryBetween) {
  SceneBuilder build;
  const auto a = build.cube(kLow, kMiddle, 1, 1), b = build.cube({1, -1, -1}, kHigh, 2, 2);
  EXPECT_EQ(along_x(build, build.combine(Operation::union_of, a, b)),
            (std::vector<Found>{{0, true, 1, 0}, {2, false, 2, 1}}));
}

TEST_P(Coincident, TouchingSolidsHaveNoIntersection) {
  SceneBuilder build;
  const auto a = build.cube(kLow, kMiddle), b = build.cube({1, -1, -1}, kHigh);
  EXPECT_TRUE(along_x(build, build.combine(Operation::intersection, a, b)).empty());
}

TEST_P(Coincident, SubtrahendThatTouchesTakesNothing) {
  SceneBuilder build;
  const auto a = build.cube(kLow, kMiddle, 1, 1), b = build.cube({1, -1, -1}, kHigh, 2, 2);
  EXPECT_EQ(along_x(build, build.combine(Operation::difference, a, b)),
            (std::vector<Found>{{0, true, 1, 0}, {1, false, 1, 1}}));
  // B's entry turns the same way as the result there; the lower number names it.
  SceneBuilder other;
  const auto c = other.cube(kLow, kMiddle, 1, 9), d = other.cube({1, -1, -1}, kHigh, 2, 2);
  EXPECT_EQ(along_x(other, other.combine(Operation::difference, c, d)),
            (std::vector<Found>{{0, true, 9, 0}, {1, false, 2, 0}}));
}

TEST_P(Coincident, FlushCutLeavesNoSkin) {
  SceneBuilder build;
  const auto a = build.cube(kLow, kHigh, 1, 1), b = build.cube(kLow, kMiddle, 2, 2);
  EXPECT_EQ(along_x(build, build.combine(Operation::difference, a, b)),
            (std::vector<Found>{{1, true, 2, 1}, {2, false, 1, 1}}));
}

TEST_P(Coincident, HiddenSurfacesDoNotNameTheBoundary) {
  // D & E is empty, so that D's face, of the lowest number, is no boundary of it.
  SceneBuilder build;
  const auto a = build.cube(kLow, kMiddle, 1, 5);
  const auto d = build.cube(kLow, kMiddle, 2, 1), e = build.cube({0, 5, 5}, {1, 6, 6}, 3, 2);
  const auto empty = build.combine(Operation::intersection, d, e);
  EXPECT_EQ(along_x(build, build.combine(Operation::union_of, a, empty)),
            (std::vector<Found>{{0, true, 5, 0}, {1, false, 5, 1}}));
}

TEST_P(Coincident, FacesByDifferentMatricesAreStillOne) {
  // The same plane by two roundings: 0.1 + 0.2 and 0.3.
  SceneBuilder build;
  const auto a = build.cube({0.1, -1, -1}, {0.1 + 0.2, 1, 1}, 1, 1);
  const auto b = build.cube({0.3, -1, -1}, {0.7, 1, 1}, 2, 2);
  const auto found = along_x(build, build.combine(Operation::union_of, a, b), {1, 0.013, 0.017});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].node, 1);
  EXPECT_EQ(found[1].node, 2);
}

TEST_P(Coincident, ShellOfOneTenTrillionthSurvives) {
  SceneBuilder build;
  const auto a = build.cube({0, -1, -1}, {1, 1, 1}, 1, 1);
  const auto b = build.cube({1e-13, -2, -2}, {2, 2, 2}, 2, 2);
  const auto found = along_x(build, build.combine(Operation::difference, a, b));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].node, 1);
  EXPECT_EQ(found[1].node, 2);
}

// A plate with flush inlays and flush neighbours, lit: no speckle, and no
// shadow of a face on itself however flat the light comes in.
TEST(CoincidentImage, FlushPlatesAreEvenlyLit) {
  for (const double tilt : {0.0, 0.3}) {
    SceneBuilder build;
    const double c = std::cos(tilt), s = std::sin(tilt);
    const auto plate = [&](double x, std::int64_t number) {
      Placement placement = test::placed({1, 0.2, 3}, {0, 0, 0});
      placement.linear = glm::dmat3({c, s, 0}, {-s, c, 0}, {0, 0, 1}) * placement.linear;
      placement.translation = {c * x, s * x, -1.5};
      return build.primitive(PrimitiveKind::cube, placement, 1, number);
    };
    auto solid = plate(-1.5, 1);
    for (int i = 1; i < 6; ++i)  // overlapping by half: coplanar tops
      solid = build.combine(Operation::union_of, solid, plate(-1.5 + 0.5 * i, i + 1));
    Scene scene = build.finish(solid);
    scene.camera = {{3, 2}, {0.1, 0.2, 0}, {-0.1, -1, -0.2}, 5, {0, 0, -1}, false, 5, false};
    scene.lighting.ambient = glm::dvec3(0);
    scene.lighting.background = {0, 0, 1};
    scene.lighting.lights = {{{40 * c - 1.1 * s, 40 * s + 1.1 * c, 0.7}, glm::dvec3(30)}};  // flat
    RenderOptions options;
    options.size = {120, 80};
    options.trace.allowed_effects.highlight = false;
    const Planes lit = render(scene, options).planes;
    options.trace.allowed_effects.shadow = false;
    const Planes unshadowed = render(scene, options).planes;
    EXPECT_EQ(lit, unshadowed) << tilt;
    std::size_t bright = 0;
    for (std::size_t p = 0; p < lit.size.pixels(); ++p) bright += lit.at(p).r > 30;
    EXPECT_GT(bright, lit.size.pixels() / 3);
  }
}

}  // namespace
}  // namespace sir
