// What the fast intersection is certain of holds in exact arithmetic, and its
// errors are within its bounds: over placements and rays of every kind.
#include "tracer/intersect_exact.h"

#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/solid.h"

namespace sir {
namespace {

constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere, PrimitiveKind::cone,
                                    PrimitiveKind::cylinder};

struct Tally {
  int crossing = 0, missing = 0, unsure = 0;
};

double power_of_ten(std::mt19937_64& random, int most) {
  std::uniform_real_distribution<double> any(-1, 1);
  return std::pow(10.0, most * any(random));
}

// A placement that may be stretched by up to 10^6 each way, sheared and moved.
Placement any_placement(std::mt19937_64& random) {
  Placement placement = test::random_placement(random, 1, true);
  const auto choice = random() % 4;
  for (int c = 0; c < 3; ++c)
    if (choice == 1) placement.linear[c] *= power_of_ten(random, 6);
  if (choice == 2) placement.linear[1] += 1e5 * placement.linear[0];
  if (choice == 3) placement = test::placed(glm::dvec3(1 + double(random() % 8)), glm::dvec3(2));
  if (random() % 4 == 0) placement.translation *= power_of_ten(random, 8);
  return placement;
}

template <typename T>
void compare(PrimitiveKind kind, std::uint64_t seed, Tally& tally) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  test::SceneBuilder build;
  const Scene scene = build.finish(build.primitive(kind, any_placement(random)));
  const Placement& placement = scene.tree.nodes[0].placement;
  const Solid<T> solid = build_solid<T>(scene);
  for (int n = 0; n < 40; ++n) {
    // Towards a place in or near the solid, from near or far; at times on an edge.
    glm::dvec3 aim(any(random), any(random), any(random));
    if (n % 4 == 0) aim = glm::round(aim);
    if (n % 8 == 1) aim = glm::normalize(aim) * (1 + 1e-9 * any(random));
    const glm::dvec3 target = placement.linear * aim + placement.translation;
    const glm::dvec3 way = placement.linear * glm::dvec3(any(random), any(random), any(random)) *
                           power_of_ten(random, n % 3 ? 1 : 6);
    RayCena<T> ray{{glm::vec<3, T>(target - way)},
                   {glm::vec<3, T>(scaled_near_one(n % 5 ? way : glm::round(way)))}};
    if (kWiderThanDouble<T> && n % 3 == 0)  // digits that a double does not hold
      for (int axis = 0; axis < 3; ++axis) ray.origin.v[axis] *= 1 + T(any(random)) * 0x1p-53L;
    if (ray.direction.v == glm::vec<3, T>(0)) continue;
    Span<T> fast, exact;
    const Crossing crossing = intersect(kind, solid.leaves[0].to_local(ray, T(1)), fast);
    const bool crosses = intersect_exactly(kind, placement, ray, T(0), exact);
    if (crossing == Crossing::unsure) {
      ++tally.unsure;
      continue;
    }
    ++(crosses ? tally.crossing : tally.missing);
    ASSERT_EQ(crossing == Crossing::crosses, crosses) << "seed " << seed << " ray " << n;
    if (!crosses) continue;
    // The exact ends are rounded themselves.
    const T u = Numeric<T>::kEpsilon;
    ASSERT_LE(std::abs(fast.enter - exact.enter), fast.enter_error + u * std::abs(exact.enter))
        << "seed " << seed << " ray " << n;
    ASSERT_LE(std::abs(fast.leave - exact.leave), fast.leave_error + u * std::abs(exact.leave))
        << "seed " << seed << " ray " << n;
    ASSERT_EQ(fast.enter_face, exact.enter_face) << "seed " << seed << " ray " << n;
    ASSERT_EQ(fast.leave_face, exact.leave_face) << "seed " << seed << " ray " << n;
  }
}

class FastAndExact : public testing::TestWithParam<PrimitiveKind> {};
INSTANTIATE_TEST_SUITE_P(All, FastAndExact, testing::ValuesIn(kKinds));

TEST_P(FastAndExact, DoubleIsWithinItsBounds) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(2500); ++seed) {
    ASSERT_NO_FATAL_FAILURE(compare<double>(GetParam(), seed, tally));
  }
  EXPECT_GT(tally.crossing, 10000);
  EXPECT_GT(tally.missing, 10000);
  EXPECT_GT(tally.unsure, 100);
}

TEST_P(FastAndExact, LongDoubleIsWithinItsBounds) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(2500); ++seed) {
    ASSERT_NO_FATAL_FAILURE(compare<long double>(GetParam(), seed, tally));
  }
  EXPECT_GT(tally.crossing, 10000);
  EXPECT_GT(tally.missing, 10000);
  EXPECT_GT(tally.unsure, 100);
}

TEST_P(FastAndExact, FloatIsWithinItsBounds) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(2500); ++seed) {
    ASSERT_NO_FATAL_FAILURE(compare<float>(GetParam(), seed, tally));
  }
  EXPECT_GT(tally.crossing, 10000);
  EXPECT_GT(tally.missing, 10000);
  EXPECT_GT(tally.unsure, 100);
}

// The line from P through the solid's middle, in numbers of SC_LOCAL: the exact
// ends are known there, whatever the placement makes of the digits.
bool cross(PrimitiveKind kind, const Placement& placement, const glm::dvec3& origin,
           const glm::dvec3& direction, Span<double>& span) {
  return intersect_exactly(kind, placement, RayCena<double>{{origin}, {direction}}, 0.0, span);
}

TEST(IntersectExactly, NumbersFarApartNeitherVanishNorEndTheProgram) {
  // Powers of two keep the placement exact: -2 to 2 along a diagonal meets the
  // sphere at 1/sqrt(3) either side of the middle, the cube from 0 to 1.
  for (const int x : {-480, -220, 0, 220, 480})
    for (const int y : {-480, -3, 350})
      for (const int z : {-400, 0, 480}) {
        const glm::dvec3 size(std::ldexp(1.0, x), std::ldexp(1.0, y), std::ldexp(1.0, z));
        Span<double> span;
        ASSERT_TRUE(cross(PrimitiveKind::sphere, test::placed(size, {}), -2.0 * size, size, span))
            << x << " " << y << " " << z;
        EXPECT_DOUBLE_EQ(span.enter, 2 - 1 / std::sqrt(3.0));
        EXPECT_DOUBLE_EQ(span.leave, 2 + 1 / std::sqrt(3.0));
        ASSERT_TRUE(cross(PrimitiveKind::cube, test::placed(size, {}), -2.0 * size, size, span));
        EXPECT_DOUBLE_EQ(span.enter, 2);
        EXPECT_DOUBLE_EQ(span.leave, 3);
        // Tangent along X: no hit however far apart the numbers lie.
        EXPECT_FALSE(cross(PrimitiveKind::sphere, test::placed(size, {}),
                           size * glm::dvec3(-2, 1, 0), size * glm::dvec3(1, 0, 0), span));
      }
}

TEST(IntersectExactly, TinySolidsOfGeneralPlacement) {
  for (const double scale : {1e-66, 1e-80, 1e-100, 1e60, 1e100}) {
    Placement placement;
    placement.linear = scale * glm::dmat3(0.3, 0.7, -0.2, 0.1, -0.9, 0.45, 0.77, 0.21, 0.35);
    Span<double> span;
    // Along the first column from twice its length: -2 to -1 ... 1.
    ASSERT_TRUE(cross(PrimitiveKind::sphere, placement, -2.0 * placement.linear[0],
                      placement.linear[0], span))
        << scale;
    EXPECT_NEAR(span.enter, 1, 1e-14);
    EXPECT_NEAR(span.leave, 3, 1e-14);
  }
}

// The squares of such distances are no doubles: the side's boundaries were lost, and a ray that
// passes between the caps' planes met the solid wherever it was.
TEST(IntersectExactly, SolidsAtDistancesWhoseSquaresOverflow) {
  for (const double far : {1e150, 5.4e187, 1e250})
    for (const PrimitiveKind kind : kKinds) {
      Span<double> span;
      EXPECT_FALSE(cross(kind, {}, {far, 0.5, 0.4375}, {-0.94, -0.34, 0}, span)) << far;
      EXPECT_FALSE(cross(kind, {}, {-far, 0.5, far}, {0.94, 0.34, 0.5}, span)) << far;
      ASSERT_TRUE(cross(kind, {}, {far, 0.5, 0.25}, {-1, 0, 0}, span)) << far;
      EXPECT_DOUBLE_EQ(span.enter, far);
    }
}

TEST(IntersectExactly, WhatIsNotFiniteMisses) {
  Span<double> span;
  const double huge = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(cross(PrimitiveKind::sphere, {}, {huge, 0, 0}, {1, 0, 0}, span));
  EXPECT_FALSE(cross(PrimitiveKind::sphere, {}, {0, 0, 0}, {0, huge, 0}, span));
  EXPECT_FALSE(cross(PrimitiveKind::sphere, {}, {0, 0, 0}, {0, 0, 0}, span));
}

}  // namespace
}  // namespace sir
