// The oracle against answers worked out by hand, so that it cannot be vacuous.
#include "tests/exact_oracle.h"

#include <gtest/gtest.h>

#include "tests/scene_builder.h"

namespace sir::test {
namespace {

struct Known {
  double t;
  bool entering;
  std::int64_t node;
  int face;
};

void expect_hits(const Scene& scene, glm::dvec3 origin, glm::dvec3 direction,
                 const std::vector<Known>& known) {
  const ExactOracle oracle(scene);
  const ExactAnswer answer = oracle.answer(origin, direction);
  EXPECT_TRUE(answer.definite);
  EXPECT_EQ(oracle.disagreement(origin, direction, 53), "");
  ASSERT_EQ(answer.hits.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_NEAR(answer.hits[i].t.convert_to<double>(), known[i].t, 1e-15) << i;
    EXPECT_EQ(answer.hits[i].entering, known[i].entering) << i;
    EXPECT_EQ(answer.hits[i].node, known[i].node) << i;
    EXPECT_EQ(answer.hits[i].face, known[i].face) << i;
  }
}

Scene one(PrimitiveKind kind, const Placement& placement = {}) {
  SceneBuilder build;
  return build.finish(build.primitive(kind, placement, 1, 7));
}

TEST(OracleSelfcheck, UnitSphere) {
  const Scene scene = one(PrimitiveKind::sphere);
  expect_hits(scene, {0, 0, -3}, {0, 0, 1}, {{2, true, 7, 0}, {4, false, 7, 0}});
  expect_hits(scene, {0, 0, 0}, {0, 0, 2}, {{0.5, false, 7, 0}});
  expect_hits(scene, {0, 0, -1}, {0, 0, 1}, {{0, true, 7, 0}, {2, false, 7, 0}});
  expect_hits(scene, {0, 0, 1}, {0, 0, 1}, {{0, false, 7, 0}});
  expect_hits(scene, {1, 0, -3}, {0, 0, 1}, {});  // touches
  // One unit in the last place inside: a chord of half-length sqrt(2^-52) (1 - ...).
  expect_hits(scene, {1 - 0x1p-53, 0, -3}, {0, 0, 1},
              {{3 - 0x1p-26, true, 7, 0}, {3 + 0x1p-26, false, 7, 0}});
  expect_hits(scene, {0, 0, 3}, {0, 0, 1}, {});  // behind
}

TEST(OracleSelfcheck, TouchInAnglesThatDoNotTerminate) {
  // Radius 3, point (1,2,2), direction (2,1,-2): perpendicular, and neither the
  // inverse 1/3 nor the unit direction is a double.
  const Scene scene = one(PrimitiveKind::sphere, placed(glm::dvec3(3), {0, 0, 0}));
  const glm::dvec3 at(1, 2, 2), along(2, 1, -2);
  expect_hits(scene, at - 5.0 * along, along, {});
  expect_hits(scene, at, along, {});
  EXPECT_EQ(ExactOracle(scene).answer({1, 2, 2 - 0x1p-51}, along).hits.size(), 1u);
  EXPECT_EQ(ExactOracle(scene).answer({1, 2, 2 + 0x1p-51}, along).hits.size(), 0u);
}

TEST(OracleSelfcheck, Cone) {
  const Scene scene = one(PrimitiveKind::cone);
  expect_hits(scene, {0, 2, 0}, {0, -1, 0}, {{1, true, 7, 0}, {2, false, 7, 1}});  // through apex
  expect_hits(scene, {-2, 1, 0}, {1, 0, 0}, {});                                   // touches it
  expect_hits(scene, {0, 2, 0}, {1, -1, 0}, {});    // along a generator
  expect_hits(scene, {-2, 1.5, 0}, {1, 0, 0}, {});  // the upper nappe
  expect_hits(scene, {-2, 0.5, 0}, {1, 0, 0}, {{1.5, true, 7, 0}, {2.5, false, 7, 0}});
  // Parallel to a generator: x = -1/2 + t, y = t: one side only, at x + y = 1.
  expect_hits(scene, {-1.5, -1, 0}, {1, 1, 0}, {{1, true, 7, 1}, {1.75, false, 7, 0}});
  expect_hits(scene, {0, -1, 0}, {1, 1, 0}, {});  // meets the rim only
}

TEST(OracleSelfcheck, CylinderAndCube) {
  const Scene tube = one(PrimitiveKind::cylinder);
  expect_hits(tube, {0.5, -1, 0}, {0, 1, 0}, {{1, true, 7, 0}, {2, false, 7, 1}});
  expect_hits(tube, {1, -1, 0}, {0, 1, 0}, {});  // in the side
  expect_hits(tube, {-2, 1, 0}, {1, 0, 0}, {});  // in a cap
  expect_hits(tube, {-2, 0.5, 0}, {1, 0, 0}, {{1, true, 7, 2}, {3, false, 7, 2}});
  const Scene cube = one(PrimitiveKind::cube);
  expect_hits(cube, {-1, -1, -1}, {1, 1, 1}, {{1, true, 7, 0}, {2, false, 7, 1}});   // corners
  expect_hits(cube, {-1, 0.5, -1}, {1, 0, 1}, {{1, true, 7, 0}, {2, false, 7, 1}});  // edges
  expect_hits(cube, {-1, 0.5, 1}, {1, 0, -1}, {});                                   // one edge
  expect_hits(cube, {-1, 0.5, 1}, {1, -0.0, 0}, {});                                 // in a face
  expect_hits(cube, {2, 0.5, 0.25}, {-0.5, -0.0, 0}, {{2, true, 7, 1}, {4, false, 7, 0}});
}

TEST(OracleSelfcheck, NearAnEdgeTheLowestFaceNames) {
  const Scene cube = one(PrimitiveKind::cube);
  // Past the edge by 2 ulp, then by 512: the face entered last is Y=0, the one left
  // first Y=1; within 32 ulp X=0 and X=1 name them.
  expect_hits(cube, {-1, -1 - 0x1p-51, 0.5}, {1, 1, 0}, {{1, true, 7, 0}, {2, false, 7, 1}});
  expect_hits(cube, {-1, -1 + 0x1p-51, 0.5}, {1, 1, 0}, {{1, true, 7, 0}, {2, false, 7, 1}});
  const double far = 0x1p-43;
  expect_hits(cube, {-1, -1 - far, 0.5}, {1, 1, 0}, {{1 + far, true, 7, 2}, {2, false, 7, 1}});
  expect_hits(cube, {-1, -1 + far, 0.5}, {1, 1, 0}, {{1, true, 7, 0}, {2 - far, false, 7, 3}});
  // In float it is an edge still.
  const auto answer = ExactOracle(cube).answer({-1, -1 - far, 0.5}, {1, 1, 0}, {24, 0});
  EXPECT_EQ(answer.hits[0].face, 0);
  EXPECT_FALSE(answer.hits[0].own_face);
  // The rim of a cone, passed below: the base is entered last, the side names.
  const Scene cone = one(PrimitiveKind::cone);
  expect_hits(cone, {-2, -0.5 - 0x1p-52, 0}, {1, 0.5, 0},
              {{1, true, 7, 0}, {7.0 / 3, false, 7, 0}});
  // A chord of 2 ulp is none.
  expect_hits(cone, {-1 + 0x1p-51, -1, 0}, {0, 1, 0}, {});
}

TEST(OracleSelfcheck, MirrorsAndScalesKeepT) {
  Placement mirrored = placed({-1, 3, 1e-6}, {5, 0, 0});
  expect_hits(one(PrimitiveKind::cube, mirrored), {8, 1, 5e-7}, {-4, 0, 0},
              {{0.75, true, 7, 0}, {1, false, 7, 1}});
}

TEST(OracleSelfcheck, SolidWithItself) {
  for (const auto operation :
       {Operation::union_of, Operation::intersection, Operation::difference}) {
    SceneBuilder build;
    const auto a = build.cube({0, 0, 0}, {1, 1, 1}, 1, 8),
               b = build.cube({0, 0, 0}, {1, 1, 1}, 1, 3);
    const Scene scene = build.finish(build.combine(operation, a, b));
    std::vector<Known> known;
    if (operation != Operation::difference) known = {{1, true, 3, 0}, {2, false, 3, 1}};
    expect_hits(scene, {-1, 0.3, 0.4}, {1, 0.1, 0}, known);
  }
}

TEST(OracleSelfcheck, TouchingCubes) {
  const auto scene = [](Operation operation) {
    SceneBuilder build;
    const auto a = build.cube({0, 0, 0}, {1, 1, 1}, 1, 9),
               b = build.cube({1, 0, 0}, {2, 1, 1}, 1, 2);
    return build.finish(build.combine(operation, a, b));
  };
  const glm::dvec3 from(-1, 0.5, 0.5), along(1, 0, 0);
  expect_hits(scene(Operation::union_of), from, along, {{1, true, 9, 0}, {3, false, 2, 1}});
  expect_hits(scene(Operation::intersection), from, along, {});
  // The subtrahend's entry, turned round, is an exit as well: the lower number.
  expect_hits(scene(Operation::difference), from, along, {{1, true, 9, 0}, {2, false, 2, 0}});
}

TEST(OracleSelfcheck, SliversAreKeptAndRoundingsAreNot) {
  const auto scene = [](double gap) {
    SceneBuilder build;
    const auto a = build.cube({0, 0, 0}, {1, 1, 1}, 1, 1);
    const auto b = build.cube({gap, -1, -1}, {2, 2, 2}, 1, 2);
    return build.finish(build.combine(Operation::difference, a, b));
  };
  const glm::dvec3 from(-1, 0.5, 0.5), along(1, 0, 0);
  expect_hits(scene(0x1p-40), from, along, {{1, true, 1, 0}, {1 + 0x1p-40, false, 2, 0}});
  expect_hits(scene(0x1p-48), from, along, {});                            // 16 ulp of t = 1
  EXPECT_FALSE(ExactOracle(scene(0x1p-47)).answer(from, along).definite);  // 32 ulp
  // In float 2^-40 is no gap, and 2^-16 is.
  EXPECT_EQ(ExactOracle(scene(0x1p-40)).answer(from, along, {24, 0}).hits.size(), 0u);
  EXPECT_EQ(ExactOracle(scene(0x1p-16)).answer(from, along, {24, 0}).hits.size(), 2u);
}

TEST(OracleSelfcheck, HiddenSurfacesDoNotName) {
  SceneBuilder build;
  const auto a = build.cube({0, 0, 0}, {1, 1, 1}, 1, 5);
  const auto d = build.cube({0, 0, 0}, {1, 1, 1}, 1, 1), e = build.cube({0, 5, 5}, {1, 6, 6}, 1, 2);
  const auto empty = build.combine(Operation::intersection, d, e);
  expect_hits(build.finish(build.combine(Operation::union_of, a, empty)), {-1, 0.5, 0.5}, {1, 0, 0},
              {{1, true, 5, 0}, {2, false, 5, 1}});
}

TEST(OracleSelfcheck, BackwardErrorCountsRoundings) {
  const ExactOracle oracle(one(PrimitiveKind::cube));
  // x = -1 + t: at t = 1 + 2^-50 the plane is missed by 2^-50, and the inputs
  // -1 (origin) and t 1 (direction) weigh 2^-53 each: about 4 roundings.
  const auto backward = oracle.backward_error(0, 0, {-1, 0.5, 0.5}, {1, 0, 0}, 1 + 0x1p-50);
  EXPECT_NEAR(backward.roundings, 4, 1e-6);
  EXPECT_NEAR(backward.one_rounding, 0x1p-52, 1e-20);
  EXPECT_EQ(oracle.backward_error(0, 0, {-1, 0.5, 0.5}, {1, 0, 0}, 1).roundings, 0);
}

TEST(OracleSelfcheck, RoundingsMakeNearThingsIndefinite) {
  const ExactOracle oracle(one(PrimitiveKind::sphere));
  const Allowance allowed{24, 16};
  EXPECT_TRUE(oracle.answer({0.5, 0, -3}, {0, 0, 1}, allowed).definite);
  EXPECT_FALSE(oracle.answer({1, 0, -3}, {0, 0, 1}, allowed).definite);
  EXPECT_FALSE(oracle.answer({0, 0, -1}, {0, 0, 1}, allowed).definite);
  EXPECT_TRUE(oracle.answer({1.5, 0, -3}, {0, 0, 1}, allowed).definite);
}

}  // namespace
}  // namespace sir::test
