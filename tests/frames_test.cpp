#include "tracer/frames.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace sir {
namespace {

template <typename A, typename B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <typename A, typename B>
concept Subtracts = requires(A a, B b) {
  a - b;
};
template <typename A, typename B>
concept Dots = requires(A a, B b) {
  dot(a, b);
};
template <typename M, typename A>
concept Applies = requires(M m, A a) {
  m.apply(a);
};
template <typename M, typename A>
concept Unapplies = requires(M m, A a) {
  m.unapply(a);
};

// Mixed frames and mixed scalars must not compile; each line also has the
// counterpart that must, or the check would be void.
static_assert(Adds<PointCena<double>, VectorCena<double>>);
static_assert(!Adds<PointCena<double>, VectorLocal<double>>);
static_assert(!Adds<PointCena<double>, VectorCena<float>>);
static_assert(!Adds<PointCena<double>, PointCena<double>>);
static_assert(Subtracts<PointCena<double>, PointCena<double>>);
static_assert(!Subtracts<PointCena<double>, PointLocal<double>>);
static_assert(Dots<NormalCena<double>, VectorCena<double>>);
static_assert(!Dots<NormalLocal<double>, VectorCena<double>>);
static_assert(Applies<LocalCena<double>, PointLocal<double>>);
static_assert(!Applies<LocalCena<double>, PointCena<double>>);
static_assert(Unapplies<LocalCena<double>, RayCena<double>>);
static_assert(!Unapplies<LocalCena<double>, RayLocal<double>>);

TEST(Frames, TransformTakesFileLinesAsColumns) {
  // File: x' = y, y' = z, z' = x, moved by (10, 20, 30), as a matrix for row vectors:
  // 0 0 1 / 1 0 0 / 0 1 0 / 10 20 30.
  LocalCena<double> m;
  m.linear[0] = {0, 0, 1};
  m.linear[1] = {1, 0, 0};
  m.linear[2] = {0, 1, 0};
  m.numerators = glm::transpose(m.linear);
  m.translation = {10, 20, 30};
  const auto p = m.apply(PointLocal<double>{{1, 2, 3}});
  EXPECT_EQ(p.v, glm::dvec3(12, 23, 31));
  EXPECT_EQ(m.unapply(p).v, glm::dvec3(1, 2, 3));
  EXPECT_EQ(m.apply(VectorLocal<double>{{1, 2, 3}}).v, glm::dvec3(2, 3, 1));
}

TEST(Frames, NormalStaysNormalUnderShear) {
  LocalCena<double> m;
  m.linear[1] = {0.5, 1, 0};  // y leans towards x
  m.numerators[1] = {-0.5, 1, 0};
  const auto n = m.apply(NormalLocal<double>{{1, 0, 0}});
  for (const auto& tangent : {VectorLocal<double>{{0, 1, 0}}, VectorLocal<double>{{0, 0, 1}}})
    EXPECT_EQ(dot(n, m.apply(tangent)), 0);
  EXPECT_EQ(dot(n, m.apply(VectorLocal<double>{{1, 0, 0}})), 1);
}

TEST(Frames, RayKeepsItsParameter) {
  LocalCena<double> m;
  m.linear[0] = {2, 0, 0};
  m.divisors.x = 2;
  m.translation = {1, 0, 0};
  const RayCena<double> ray{{{5, 1, 2}}, {{-2, 0, 1}}};
  EXPECT_EQ(m.apply(m.unapply(ray).at(3)).v, ray.at(3).v);
}

}  // namespace
}  // namespace sir
