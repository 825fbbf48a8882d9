// Combination of classifications: table 2.4 and its consequences.
#include "tracer/classify.h"

#include <gtest/gtest.h>

#include "tests/scene_builder.h"
#include "tracer/probe.h"

namespace sir {
namespace {

using test::SceneBuilder;

// Two slabs along x, [0,4] and [2,6], wide in y and z.
struct TwoSlabs {
  SceneBuilder build;
  SceneBuilder::Id left = build.cube({0, -1, -1}, {4, 1, 1}, 1, 10);
  SceneBuilder::Id right = build.cube({2, -1, -1}, {6, 1, 1}, 2, 20);
};

std::string along_x(const Scene& scene, Engine engine, double from = -1) {
  const auto prober = make_prober(scene, Precision::double_, engine);
  std::string text;
  for (const ProbeHit& hit : prober->hits({from, 0.1, 0.2}, {1, 0, 0}))
    text += (hit.entering ? "in " : "out ") + std::to_string(from + hit.t).substr(0, 4) + " node " +
            std::to_string(hit.node) + " face " + std::to_string(hit.face) + " surface " +
            std::to_string(hit.surface) + "; ";
  return text;
}

class Engines : public testing::TestWithParam<Engine> {};
INSTANTIATE_TEST_SUITE_P(Both, Engines, testing::Values(Engine::gates, Engine::roth));

TEST_P(Engines, TableTwoFourRowByRow) {
  // Membership at 1 (IN, OUT), 3 (IN, IN), 5 (OUT, IN) and 7 (OUT, OUT).
  const struct {
    Operation operation;
    bool in_out, in_in, out_in;
  } rows[] = {{Operation::union_of, true, true, true},
              {Operation::difference, true, false, false},
              {Operation::intersection, false, true, false}};
  for (const auto& row : rows) {
    TwoSlabs slabs;
    const Scene scene =
        slabs.build.finish(slabs.build.combine(row.operation, slabs.left, slabs.right));
    const auto prober = make_prober(scene, Precision::double_, GetParam());
    const auto inside = [&](double x) {
      const auto& hits = prober->hits({x, 0.1, 0.2}, {1, 0, 0});
      return !hits.empty() && !hits.front().entering;
    };
    EXPECT_EQ(inside(1), row.in_out);
    EXPECT_EQ(inside(3), row.in_in);
    EXPECT_EQ(inside(5), row.out_in);
    EXPECT_FALSE(inside(7));
    EXPECT_FALSE(inside(-1));
  }
}

TEST_P(Engines, BoundariesAreNamedByTheSurfaceThatMakesThem) {
  const auto scene_of = [](Operation operation) {
    TwoSlabs slabs;
    return slabs.build.finish(slabs.build.combine(operation, slabs.left, slabs.right));
  };
  EXPECT_EQ(along_x(scene_of(Operation::union_of), GetParam()),
            "in 0.00 node 10 face 0 surface 1; out 6.00 node 20 face 1 surface 2; ");
  EXPECT_EQ(along_x(scene_of(Operation::intersection), GetParam()),
            "in 2.00 node 20 face 0 surface 2; out 4.00 node 10 face 1 surface 1; ");
  EXPECT_EQ(along_x(scene_of(Operation::difference), GetParam()),
            "in 0.00 node 10 face 0 surface 1; out 2.00 node 20 face 0 surface 2; ");
}

TEST_P(Engines, BoreLeavesTwoWalls) {
  SceneBuilder build;
  const auto block = build.cube({0, -1, -1}, {4, 1, 1}, 1, 1);
  const auto bore = build.cube({1, -2, -0.5}, {3, 2, 0.5}, 2, 2);
  const Scene scene = build.finish(build.combine(Operation::difference, block, bore));
  EXPECT_EQ(along_x(scene, GetParam()),
            "in 0.00 node 1 face 0 surface 1; out 1.00 node 2 face 0 surface 2; "
            "in 3.00 node 2 face 1 surface 2; out 4.00 node 1 face 1 surface 1; ");
}

TEST_P(Engines, StartInsideGivesAnOutFirst) {
  TwoSlabs slabs;
  const Scene scene =
      slabs.build.finish(slabs.build.combine(Operation::union_of, slabs.left, slabs.right));
  EXPECT_EQ(along_x(scene, GetParam(), 3), "out 6.00 node 20 face 1 surface 2; ");
  EXPECT_EQ(along_x(scene, GetParam(), 7), "");
}

TEST_P(Engines, StartOnABoundaryCounts) {
  SceneBuilder build;
  const Scene scene = build.finish(build.cube({0, 0, 0}, {1, 1, 1}));
  const auto prober = make_prober(scene, Precision::double_, GetParam());
  const auto entering = prober->hits({0, 0.5, 0.5}, {1, 0, 0});
  ASSERT_EQ(entering.size(), 2u);
  EXPECT_EQ(entering[0].t, 0);
  EXPECT_FALSE(std::signbit(entering[0].t));
  EXPECT_TRUE(entering[0].entering);
  const auto leaving = prober->hits({1, 0.5, 0.5}, {1, 0, 0});
  ASSERT_EQ(leaving.size(), 1u);
  EXPECT_EQ(leaving[0].t, 0);
  EXPECT_FALSE(leaving[0].entering);
}

TEST_P(Engines, SinglePrimitiveIsAScene) {
  SceneBuilder build;
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 2, 7, 5));
  EXPECT_EQ(along_x(scene, GetParam(), -4).substr(0, 30), "in -1.9 node 5 face 0 surface ");
}

TEST(Classify, DirectionLengthIsTheUnitOfT) {
  SceneBuilder build;
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 1));
  const auto prober = make_prober(scene, Precision::double_);
  for (const double length : {1e-150, 1e-3, 1.0, 4e7, 1e150}) {
    const auto& hits = prober->hits({0, 0, 3}, {0, 0, -length});
    ASSERT_EQ(hits.size(), 2u) << length;
    EXPECT_DOUBLE_EQ(hits[0].t, 2 / length);
    EXPECT_DOUBLE_EQ(hits[1].t, 4 / length);
  }
}

TEST(Classify, SecondaryRaysNeverMeetTheSurfaceTheyLeave) {
  // A thousand points on a sphere, outward: no hit; inward: the far side only.
  SceneBuilder build;
  const Scene scene = build.finish(build.sphere({0.3, -0.7, 1000.1}, 0.37));
  const auto solid = build_solid<double>(scene);
  Classifier<double> classifier(solid);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    const PointCena<double> p{glm::dvec3(0.3, -0.7, 1000.1) + 0.37 * normal};
    glm::dvec3 d(any(random), any(random), any(random));
    if (glm::dot(d, normal) < 0) d = -d;
    Boundary<double> boundary;
    classifier.begin({p, {d}}, {0, false, 1e-12});
    EXPECT_FALSE(classifier.next(boundary));
    classifier.begin({p, {-d}}, {0, true, 1e-12});
    ASSERT_TRUE(classifier.next(boundary));
    EXPECT_FALSE(boundary.entering);
    // The point itself is known to 1e-13; a flat angle makes the more of it.
    EXPECT_NEAR(boundary.t, 2 * 0.37 * glm::dot(d, normal) / glm::dot(d, d),
                3e-13 / glm::dot(d, normal));
    EXPECT_FALSE(classifier.next(boundary));
  }
}

// Faces, tangents and generators of solids whose size has no exact inverse: 49
// times 1/49 is not 1.
TEST(Classify, AwkwardSizesHaveExactFaces) {
  const auto hits = [](PrimitiveKind kind, const Placement& placement, glm::dvec3 o, glm::dvec3 d) {
    SceneBuilder build;
    return make_prober(build.finish(build.primitive(kind, placement)), Precision::double_)
        ->hits(o, d);
  };
  const Placement by49 = test::placed(glm::dvec3(49), {0, 0, 0});
  EXPECT_TRUE(hits(PrimitiveKind::sphere, by49, {49, 0, -5}, {0, 0, 1}).empty()) << "tangent";
  EXPECT_TRUE(hits(PrimitiveKind::cube, by49, {49, 20, -5}, {0, 0, 1}).empty()) << "in a face";
  const auto starts = hits(PrimitiveKind::cube, by49, {20, 20, 49}, {0, 0, -1});
  ASSERT_EQ(starts.size(), 2u);
  EXPECT_EQ(starts[0].t, 0);
  Placement shear = test::placed(glm::dvec3(3), {0, 0, 0});
  shear.linear[1].x = 1;
  EXPECT_TRUE(hits(PrimitiveKind::cube, shear, {3, 0, -5}, {0, 0, 1}).empty())
      << "in a sheared face";
  EXPECT_TRUE(
      hits(PrimitiveKind::cone, test::placed({3, 3, 2}, {2, -2, 1}), {0, 3, 1}, {1, -1, 0}).empty())
      << "along a generator";
  // (1,2,2) lies on the sphere of radius 3, (3,4) on the circle of radius 5.
  const Placement by3 = test::placed(glm::dvec3(3), {0, 0, 0});
  EXPECT_TRUE(hits(PrimitiveKind::sphere, by3, {5, 0, 2}, {-2, 1, 0}).empty()) << "oblique tangent";
  const auto from_sphere = hits(PrimitiveKind::sphere, by3, {1, 2, 2}, {-1, -2, -2});
  ASSERT_EQ(from_sphere.size(), 2u);
  EXPECT_EQ(from_sphere[0].t, 0);
  EXPECT_EQ(from_sphere[1].t, 2);
  const Placement by5 = test::placed(glm::dvec3(5), {0, 0, 0});
  EXPECT_TRUE(hits(PrimitiveKind::cylinder, by5, {-1, 2, 7}, {4, 0, -3}).empty());
  const auto from_side = hits(PrimitiveKind::cylinder, by5, {3, 2, 4}, {-3, 0, -4});
  ASSERT_EQ(from_side.size(), 2u);
  EXPECT_EQ(from_side[0].t, 0);
}

// A fuse of alternating operations, so that nothing can be flattened away.
Scene alternating_chain(int depth) {
  SceneBuilder build;
  auto solid = build.cube({0, -1, -1}, {0.5, 1, 1});
  for (int i = 1; i < depth; ++i) {
    const auto next = build.cube({i, -1, -1}, {i + 0.5, 1, 1});
    const auto cut = build.cube({i + 0.25, -2, -2}, {i + 0.75, 2, 2});
    solid =
        build.combine(Operation::difference, build.combine(Operation::union_of, solid, next), cut);
  }
  return build.finish(solid);
}

TEST(Classify, AlternatingChainOfTwentyThousandLevels) {
  constexpr int kDepth = 10000;
  const Scene scene = alternating_chain(kDepth);
  const auto prober = make_prober(scene, Precision::double_);
  const auto& hits = prober->hits({-1, 0, 0}, {1, 0, 0});
  ASSERT_EQ(hits.size(), 2u * kDepth);
  for (int i = 1; i < kDepth; ++i) {
    EXPECT_EQ(hits[2 * static_cast<std::size_t>(i)].t, i + 1);
    EXPECT_EQ(hits[2 * static_cast<std::size_t>(i) + 1].t, i + 1.25);
  }
}

TEST(Classify, ChainOfAHundredThousandUnions) {
  SceneBuilder build;
  auto solid = build.sphere({0, 0, 0}, 0.25);
  for (int i = 1; i <= 100000; ++i)
    solid = build.combine(Operation::union_of, solid, build.sphere({i, 0, 0}, 0.25));
  const auto prober = make_prober(build.finish(solid), Precision::double_);
  EXPECT_EQ(prober->hits({-1, 0, 0}, {1, 0, 0}).size(), 200002u);
  EXPECT_EQ(prober->hits({5000, 0, 9}, {0, 0, -1}).size(), 2u);
}

}  // namespace
}  // namespace sir
