// Long double: the digits beyond double's are kept, exactly, all the way into the
// decisions; and what double sees right looks the same in it.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/intersect_exact.h"
#include "tracer/numeric.h"
#include "tracer/render.h"

namespace sir {
namespace {

using Long = long double;
using Real = boost::multiprecision::cpp_bin_float_100;
constexpr Long kUlp = std::numeric_limits<Long>::epsilon();

bool cross(PrimitiveKind kind, const Placement& placement, const glm::vec<3, Long>& origin,
           const glm::vec<3, Long>& direction, Span<Long>& span) {
  return intersect_exactly(kind, placement, RayCena<Long>{{origin}, {direction}}, Long(0), span);
}

// One unit in the last place inside a tangent is a hit and the tangent is none:
// as doubles the two are the same number.
TEST(LongDouble, LastDigitDecidesBesideATangent) {
  if (!kWiderThanDouble<Long>) GTEST_SKIP() << "long double is no wider than double here";
  const Long inside = 1 - kUlp / 2;
  ASSERT_EQ(double(inside), 1.0);
  for (const auto kind : {PrimitiveKind::sphere, PrimitiveKind::cylinder})
    for (const double size : {1.0, 0x1p-300, 0x1p300})
      for (const Long sign : {Long(-1), Long(1)}) {
        const Placement placement = test::placed(glm::dvec3(size), {});
        const Long scale = size, y = kind == PrimitiveKind::sphere ? Long(0) : scale / 2;
        Span<Long> span;
        const glm::vec<3, Long> along(scale, 0, 0);
        EXPECT_FALSE(cross(kind, placement, {-2 * scale, y, sign * scale}, along, span));
        ASSERT_TRUE(cross(kind, placement, {-2 * scale, y, sign * inside * scale}, along, span));
        const Real half = sqrt(1 - Real(inside) * Real(inside));
        EXPECT_EQ(span.enter, (2 - half).convert_to<Long>());
        EXPECT_EQ(span.leave, (2 + half).convert_to<Long>());
      }
}

TEST(LongDouble, LastDigitDecidesBesideAFace) {
  if (!kWiderThanDouble<Long>) GTEST_SKIP() << "long double is no wider than double here";
  Span<Long> span;
  const Placement placement = test::placed(glm::dvec3(1), {3, 0, 0});
  // Beside the cube's faces, cone's base and apex, and cylinder's caps at Y = 0 and 1.
  for (const auto kind : {PrimitiveKind::cube, PrimitiveKind::cylinder})
    for (const auto& [y, hits] :
         {std::pair{1 - kUlp / 2, true}, {Long(1), false}, {1 + kUlp, false}, {Long(0), false}}) {
      EXPECT_EQ(cross(kind, placement, {-2, y, 0.5L}, {1, 0, 0}, span), hits) << double(y - 1);
      EXPECT_EQ(cross(kind, placement, {-2, y, 0.5L}, {-1, 0, 0}, span), hits) << double(y - 1);
    }
  EXPECT_FALSE(cross(PrimitiveKind::cone, placement, {-2, 1, 0}, {1, 0, 0}, span));
  ASSERT_TRUE(cross(PrimitiveKind::cone, placement, {-2, 1 - kUlp / 2, 0}, {1, 0, 0}, span));
  EXPECT_EQ(span.enter, 5);  // 5 - 2^-64 rounds to it
  // The origin's distance to the solid has more digits than a long double has:
  // it is -1 - 2^-63 - 3 exactly.
  ASSERT_TRUE(cross(PrimitiveKind::cube, placement, {-1 - kUlp, 0.5L, 0.5L}, {1, 0, 0}, span));
  EXPECT_EQ(span.enter, (Real(4) + Real(kUlp)).convert_to<Long>());
  // And the direction.
  ASSERT_TRUE(cross(PrimitiveKind::cube, placement, {-1, 0.5L, 0.5L}, {1 + kUlp, 0, 0}, span));
  EXPECT_EQ(span.enter, (Real(4) / (1 + Real(kUlp))).convert_to<Long>());
}

// Spheres of any place and shape, rays in 64 digits: both ends against the
// textbook's formula in a hundred digits.
TEST(LongDouble, EndsAreTheNearestOfAHundredDigits) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto wide = [&] { return Long(any(random)) + Long(any(random)) * 0x1p-54L; };
  int hits = 0;
  for (int n = 0; n < 4000; ++n) {
    const Placement placement = test::random_placement(random, 1, true);
    const glm::vec<3, Long> origin(3 * wide(), 3 * wide(), 3 * wide());
    const glm::vec<3, Long> aim =
        glm::vec<3, Long>(placement.translation) + glm::vec<3, Long>(wide(), wide(), wide()) * 0.5L;
    const auto direction = aim - origin;
    // Cramer: coordinates times the determinant.
    const auto& m = placement.linear;
    Real det = 0, o[3], d[3];
    for (int i = 0; i < 3; ++i) {
      const auto &a = m[(i + 1) % 3], &b = m[(i + 2) % 3];
      o[i] = d[i] = 0;
      det = 0;
      for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        const Real cofactor = Real(a[p]) * Real(b[q]) - Real(a[q]) * Real(b[p]);
        o[i] += cofactor * (Real(origin[k]) - Real(placement.translation[k]));
        d[i] += cofactor * Real(direction[k]);
        det += cofactor * Real(m[i][k]);
      }
    }
    const Real a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const Real b = o[0] * d[0] + o[1] * d[1] + o[2] * d[2];
    const Real c = o[0] * o[0] + o[1] * o[1] + o[2] * o[2] - det * det;
    const Real discriminant = b * b - a * c;
    Span<Long> span;
    ASSERT_EQ(cross(PrimitiveKind::sphere, placement, origin, direction, span), discriminant > 0)
        << n;
    if (!(discriminant > 0)) continue;
    ++hits;
    const Real root = sqrt(discriminant);
    // The nearest, but where the last rounding is of a number half-way in a hundred bits.
    for (const auto& [got, exact] :
         {std::pair{span.enter, Real((-b - root) / a)}, {span.leave, Real((-b + root) / a)}})
      ASSERT_LE(Real(abs(Real(got) - exact)), Real(abs(exact)) * Real(kUlp) * 0.5001) << n;
  }
  EXPECT_GT(hits, 1000);
}

// 0.1 + 0.2 is not 0.3 in the file's doubles; meant to coincide, the two faces are
// one in any scalar type, for primary rays and for those that leave them.
TEST(LongDouble, WhatCoincidesInDoubleCoincides) {
  test::SceneBuilder build;
  const auto lower = build.cube({-1, -1, -1}, {1, 0.1 + 0.2, 1});
  const auto upper = build.primitive(PrimitiveKind::cube, test::placed({2, 1, 2}, {-1, 0.3, -1}));
  Scene scene = build.finish(build.combine(Operation::union_of, lower, upper));
  scene.camera.window = {3, 3};
  scene.camera.target = {0, 0.3, 0};
  scene.camera.normal = {0.1, -0.2, -1};
  scene.camera.distance = scene.camera.focal = 6;
  scene.lighting = {{0, 0, 1}, glm::dvec3(0.1), {{{1, 3, 6}, glm::dvec3(1)}}};
  RenderOptions options;
  options.size = {64, 64};
  const RenderResult usual = render(scene, options);
  options.precision = Precision::long_double;
  const RenderResult wide = render(scene, options);
  EXPECT_EQ(wide.planes, usual.planes);
  EXPECT_EQ(wide.counts.shadow, usual.counts.shadow);
}

TEST(LongDouble, SeesWhatDoubleSees) {
  RenderOptions options;
  options.size = {96, 72};
  std::size_t off = 0, pixels = 0;
  for (std::uint64_t seed = 0; seed < test::cases(24); ++seed) {
    const Scene scene = test::random_scene(seed, 10, seed % 3 == 0);
    options.precision = Precision::double_;
    const Planes usual = render(scene, options).planes;
    options.precision = Precision::long_double;
    const Planes wide = render(scene, options).planes;
    for (std::size_t p = 0; p < usual.size.pixels(); ++p) off += usual.at(p) != wide.at(p);
    pixels += usual.size.pixels();
  }
  EXPECT_LE(off * 1000, pixels);
}

TEST(LongDouble, InverseHasTheDigits) {
  std::mt19937_64 random(5);
  for (int n = 0; n < 500; ++n) {
    const glm::dmat3 m = test::random_placement(random, 1, true).linear;
    InverseIn<Long> inverse;
    ASSERT_TRUE(invert(m, inverse));
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        Real product = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
          const Real term =
              Real(inverse.numerators[k][row]) * Real(m[column][k]) / Real(inverse.divisors[row]);
          product += term;
          size += abs(term);
        }
        ASSERT_LE(Real(abs(product - (row == column ? 1 : 0))), 3 * Real(kUlp) * size) << n;
      }
  }
}

}  // namespace
}  // namespace sir
