// Each primitive's spans against formulas of another kind: membership tested
// along the ray, and roots found by bisection in quadruple precision.
#include "tracer/intersect.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/intersect_exact.h"

namespace sir {
namespace {

// The classifier's way: what the fast intersection leaves open the exact one
// decides. The ray is taken as it stands, SC_LOCAL's unit being `unit` long.
template <typename T>
bool crosses(PrimitiveKind kind, const RayLocal<T>& ray, T unit, Span<T>& span) {
  LocalRay<T> local;
  local.origin = ray.origin;
  local.direction = ray.direction;
  local.unit = unit;
  const Crossing crossing = intersect(kind, local, span);
  if (crossing != Crossing::unsure) return crossing == Crossing::crosses;
  Placement placement;
  placement.linear *= double(unit);
  return intersect_exactly(kind, placement, RayCena<T>{{ray.origin.v}, {ray.direction.v}}, T(0),
                           span);
}

__extension__ typedef __float128 Quad;

// > 0 inside, by the primitives' definitions alone.
Quad depth_inside(PrimitiveKind kind, Quad x, Quad y, Quad z) {
  const auto least = [](std::initializer_list<Quad> values) {
    Quad m = *values.begin();
    for (const Quad v : values) m = v < m ? v : m;
    return m;
  };
  switch (kind) {
    case PrimitiveKind::cube: return least({x, 1 - x, y, 1 - y, z, 1 - z});
    case PrimitiveKind::sphere: return 1 - x * x - y * y - z * z;
    case PrimitiveKind::cone: return least({(1 - y) * (1 - y) - x * x - z * z, y, 1 - y});
    case PrimitiveKind::cylinder: return least({1 - x * x - z * z, y, 1 - y});
  }
  return 0;
}

// Which face's equation holds at a point of the boundary.
Quad face_equation(PrimitiveKind kind, int face, Quad x, Quad y, Quad z) {
  switch (kind) {
    case PrimitiveKind::cube: {
      const Quad c[] = {x, x - 1, y, y - 1, z, z - 1};
      return c[face];
    }
    case PrimitiveKind::sphere: return x * x + y * y + z * z - 1;
    case PrimitiveKind::cone: return face == 0 ? x * x + z * z - (y - 1) * (y - 1) : y;
    case PrimitiveKind::cylinder: return face == 2 ? x * x + z * z - 1 : y - face;
  }
  return 1;
}

class Primitives : public testing::TestWithParam<PrimitiveKind> {};
INSTANTIATE_TEST_SUITE_P(All, Primitives,
                         testing::Values(PrimitiveKind::cube, PrimitiveKind::sphere,
                                         PrimitiveKind::cone, PrimitiveKind::cylinder));

TEST_P(Primitives, SpansAgreeWithMembershipAlongTheRay) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  int hits = 0;
  for (int n = 0; n < 8000; ++n) {
    const PointLocal<double> o{{2 * any(random), 2 * any(random), 2 * any(random)}};
    const VectorLocal<double> d{{any(random), any(random), any(random)}};
    Span<double> span;
    const bool hit = crosses(GetParam(), {o, d}, 1.0, span);
    const auto inside_at = [&](Quad t) {
      return depth_inside(GetParam(), o.v.x + t * d.v.x, o.v.y + t * d.v.y, o.v.z + t * d.v.z);
    };
    if (!hit) {
      for (int k = -100; k <= 100; ++k)
        ASSERT_LE(static_cast<double>(inside_at(Quad(k) / 20)), 1e-12) << "ray " << n;
      continue;
    }
    ++hits;
    ASSERT_LT(span.enter, span.leave);
    ASSERT_GT(static_cast<double>(inside_at((Quad(span.enter) + span.leave) / 2)), 0);
    // Just inside and just outside either end, and on the face that is named.
    for (const bool entering : {true, false}) {
      const double t = entering ? span.enter : span.leave;
      const int face = entering ? span.enter_face : span.leave_face;
      const Quad step = (entering ? 1 : -1) * (Quad(span.leave) - span.enter) * 1e-6;
      ASSERT_GT(static_cast<double>(inside_at(t + step)), 0);
      ASSERT_LT(static_cast<double>(inside_at(t - step)), 0);
      const Quad at = t;
      ASSERT_NEAR(static_cast<double>(face_equation(GetParam(), face, o.v.x + at * d.v.x,
                                                    o.v.y + at * d.v.y, o.v.z + at * d.v.z)),
                  0, 1e-11);
    }
    // The root itself, by bisection.
    Quad out = span.enter - (Quad(span.leave) - span.enter) / 8,
         in = (Quad(span.enter) + span.leave) / 2;
    for (int k = 0; k < 100; ++k) {
      const Quad middle = (in + out) / 2;
      (inside_at(middle) > 0 ? in : out) = middle;
    }
    ASSERT_NEAR(static_cast<double>((in - span.enter) / (Quad(1e-3) + span.leave - span.enter)), 0,
                1e-10);
  }
  EXPECT_GT(hits, 300);
}

TEST_P(Primitives, FloatAgreesWithDouble) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<float> any(-1, 1);
  int compared = 0;
  for (int n = 0; n < 5000; ++n) {
    const glm::vec3 o(2 * any(random), 2 * any(random), 2 * any(random));
    const glm::vec3 d(any(random), any(random), any(random));
    Span<float> single;
    Span<double> exact;
    const bool a = crosses(GetParam(), RayLocal<float>{{o}, {d}}, 1.0f, single);
    const bool b =
        crosses(GetParam(), RayLocal<double>{{glm::dvec3(o)}, {glm::dvec3(d)}}, 1.0, exact);
    if (b && exact.leave - exact.enter < 1e-2) continue;  // nearly tangent
    if (a != b) {
      ASSERT_TRUE(a);
      ASSERT_LT(single.leave - single.enter, 1e-2f);
      continue;
    }
    if (!a) continue;
    ++compared;
    const double scale = 1e-4 * (1 + std::abs(exact.enter) + std::abs(exact.leave));
    ASSERT_NEAR(single.enter, exact.enter, scale);
    ASSERT_NEAR(single.leave, exact.leave, scale);
  }
  EXPECT_GT(compared, 200);
}

struct Case {
  const char* name;
  PrimitiveKind kind;
  glm::dvec3 o, d;
  bool hit;
  double enter, leave;
  int enter_face, leave_face;
};

TEST(Intersect, CasesWorkedOutByHand) {
  using K = PrimitiveKind;
  const Case cases[] = {
      {"cube along x", K::cube, {-1, 0.5, 0.25}, {1, 0, 0}, true, 1, 2, 0, 1},
      {"cube backwards", K::cube, {-1, 0.5, 0.25}, {-1, 0, 0}, true, -2, -1, 1, 0},
      {"cube along z, direction 1/2", K::cube, {0.5, 0.5, 3}, {0, 0, -0.5}, true, 4, 6, 5, 4},
      {"cube in a face", K::cube, {-1, 0, 0.5}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cube beside", K::cube, {-1, 1.5, 0.5}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cube touching an edge", K::cube, {-1, 0, 0.5}, {1, 1, 0}, false, 0, 0, 0, 0},
      {"cube touching a corner", K::cube, {-1, 0, 0}, {1, 1, -0.5}, false, 0, 0, 0, 0},
      {"cube through two edges: lower face", K::cube, {-1, -1, 0.5}, {1, 1, 0}, true, 1, 2, 0, 1},
      {"cube through two corners", K::cube, {-1, -1, -1}, {1, 1, 1}, true, 1, 2, 0, 1},
      {"cube parallel, minus zero", K::cube, {-1, 0.5, 0.5}, {1, -0.0, -0.0}, true, 1, 2, 0, 1},
      {"sphere through the centre", K::sphere, {0, 0, 3}, {0, 0, -2}, true, 1, 2, 0, 0},
      {"sphere tangent", K::sphere, {1, 0, 3}, {0, 0, -1}, false, 0, 0, 0, 0},
      {"sphere from inside", K::sphere, {0, 0, 0}, {0, 4, 0}, true, -0.25, 0.25, 0, 0},
      {"cylinder across", K::cylinder, {-3, 0.5, 0}, {1, 0, 0}, true, 2, 4, 2, 2},
      {"cylinder along its axis", K::cylinder, {0.25, 3, 0.25}, {0, -1, 0}, true, 2, 3, 1, 0},
      {"cylinder in at the top, out at the side",
       K::cylinder,
       {0, 2, 0},
       {1, -2, 0},
       true,
       0.5,
       1,
       1,
       0},
      {"cylinder in a generator", K::cylinder, {1, 3, 0}, {0, -1, 0}, false, 0, 0, 0, 0},
      {"cylinder in the cap's plane", K::cylinder, {-3, 1, 0}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cylinder tangent", K::cylinder, {-3, 0.5, 1}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cone across at half height", K::cone, {-3, 0.5, 0}, {1, 0, 0}, true, 2.5, 3.5, 0, 0},
      {"cone down its axis through the apex", K::cone, {0, 3, 0}, {0, -1, 0}, true, 2, 3, 0, 1},
      {"cone up its axis", K::cone, {0, -1, 0}, {0, 1, 0}, true, 1, 2, 1, 0},
      {"cone beside its axis", K::cone, {0.5, 3, 0}, {0, -1, 0}, true, 2.5, 3, 0, 1},
      {"cone along a generator", K::cone, {1, 0, 0}, {-1, 1, 0}, false, 0, 0, 0, 0},
      {"cone parallel to a generator", K::cone, {0, 0, 0}, {-1, 1, 0}, true, 0, 0.5, 1, 0},
      {"cone parallel to a generator, from above",
       K::cone,
       {-1, 1, 0},
       {1, -1, 0},
       true,
       0.5,
       1,
       0,
       1},
      {"cone parallel to a generator, the upper nappe",
       K::cone,
       {0, 1.5, 0},
       {1, 1, 0},
       false,
       0,
       0,
       0,
       0},
      {"cone flat through the apex", K::cone, {-3, 1, 0}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cone's upper nappe", K::cone, {-3, 1.5, 0}, {1, 0, 0}, false, 0, 0, 0, 0},
      {"cone in the base's plane", K::cone, {-3, 0, 0}, {1, 0, 0}, false, 0, 0, 0, 0},
  };
  for (const Case& c : cases) {
    Span<double> span{};
    const bool hit = crosses(c.kind, RayLocal<double>{{c.o}, {c.d}}, 1.0, span);
    ASSERT_EQ(hit, c.hit) << c.name;
    if (!hit) continue;
    EXPECT_DOUBLE_EQ(span.enter, c.enter) << c.name;
    EXPECT_DOUBLE_EQ(span.leave, c.leave) << c.name;
    EXPECT_EQ(span.enter_face, c.enter_face) << c.name;
    EXPECT_EQ(span.leave_face, c.leave_face) << c.name;
  }
}

TEST_P(Primitives, UnitIsALengthLikeAnyOther) {
  // Three times as large, three times as far: the same t, but for rounding.
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> any(-1, 1);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const glm::dvec3 o(2 * any(random), 2 * any(random), 2 * any(random));
    const glm::dvec3 d(any(random), any(random), any(random));
    Span<double> one, three;
    const bool hit = crosses(GetParam(), RayLocal<double>{{o}, {d}}, 1.0, one);
    ASSERT_EQ(crosses(GetParam(), RayLocal<double>{{o * 3.0}, {d * 3.0}}, 3.0, three), hit);
    if (!hit || one.leave - one.enter < 1e-3) continue;
    ++hits;
    ASSERT_NEAR(three.enter, one.enter, 1e-11 * (1 + std::abs(one.enter)));
    ASSERT_NEAR(three.leave, one.leave, 1e-11 * (1 + std::abs(one.leave)));
    ASSERT_EQ(three.enter_face, one.enter_face);
    ASSERT_EQ(three.leave_face, one.leave_face);
  }
  EXPECT_GT(hits, 100);
}

TEST(Intersect, FarQuadricsKeepTheirDigits) {
  // From 1e8 radii away, aimed so that the impact parameter is exactly known.
  for (const double distance : {1e2, 1e4, 1e6, 1e8}) {
    Span<double> span;
    ASSERT_TRUE(crosses(PrimitiveKind::sphere, RayLocal<double>{{{0.5, 0, distance}}, {{0, 0, -1}}},
                        1.0, span));
    const double half = std::sqrt(0.75);
    EXPECT_NEAR(span.enter, distance - half, 4e-16 * distance);
    EXPECT_NEAR(span.leave, distance + half, 4e-16 * distance);
    ASSERT_TRUE(crosses(PrimitiveKind::cylinder,
                        RayLocal<double>{{{0.5, 0.5, distance}}, {{0, 0, -1}}}, 1.0, span));
    EXPECT_NEAR(span.enter, distance - half, 4e-16 * distance);
    ASSERT_TRUE(crosses(PrimitiveKind::cone,
                        RayLocal<double>{{{0.25, 0.5, distance}}, {{0, 0, -1}}}, 1.0, span));
    EXPECT_NEAR(span.enter, distance - std::sqrt(0.25 - 0.0625), 4e-16 * distance);
  }
}

}  // namespace
}  // namespace sir
