#include "tracer/ray_secondary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sir {
namespace {

using V = VectorCena<double>;

TEST(RaySecondary, MirrorAtAPlane) {
  const V r = mirrored(V{{0.6, -0.8, 0}}, V{{0, 1, 0}});
  EXPECT_NEAR(r.v.x, 0.6, 1e-16);
  EXPECT_NEAR(r.v.y, 0.8, 1e-16);
  EXPECT_EQ(r.v.z, 0);
}

TEST(RaySecondary, SnellsLaw) {
  for (const double ratio : {1.0 / 1.5, 1.5, 1.33, 0.9})
    for (double angle = 0.01; angle < 1.57; angle += 0.01) {
      const V incident{{std::sin(angle), -std::cos(angle), 0}}, normal{{0, 1, 0}};
      V t;
      const double sine = std::sin(angle) * ratio;
      ASSERT_EQ(refracted(incident, normal, ratio, 1.0, t), sine <= 1);
      if (sine > 1) continue;
      EXPECT_NEAR(t.v.x, sine, 1e-15);
      EXPECT_LT(t.v.y, 0);
      EXPECT_NEAR(length(t), 1, 1e-15);
    }
}

TEST(RaySecondary, EqualIndicesChangeNothing) {
  const V incident = normalize(V{{0.3, -0.2, 0.7}});
  V t;
  ASSERT_TRUE(refracted(incident, normalize(V{{0, 1, 0.1}}), 1.5, 1.5, t));
  EXPECT_EQ(t.v, incident.v);
}

TEST(RaySecondary, RefractionReversed) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const V normal = normalize(V{{any(random), any(random), any(random)}});
    V incident = normalize(V{{any(random), any(random), any(random)}});
    if (dot(incident, normal) > 0) incident = -incident;
    V through, back;
    ASSERT_TRUE(refracted(incident, normal, 1.0, 1.5, through));
    ASSERT_TRUE(refracted(-through, -normal, 1.5, 1.0, back));
    // Near grazing the way back magnifies a rounding by 1/cos.
    EXPECT_LE(length(back + incident), 4e-15 / -dot(incident, normal));
  }
}

TEST(RaySecondary, CriticalAngleIsDecidedToTheLastDigits) {
  const double critical = std::asin(1 / 1.5);
  V t;
  for (int k = 3; k <= 15; ++k) {
    const double off = std::pow(10.0, -k);
    const auto at = [&](double angle) {
      return refracted(V{{std::sin(angle), -std::cos(angle), 0}}, V{{0, 1, 0}}, 1.5, 1.0, t);
    };
    EXPECT_TRUE(at(critical - off)) << k;
    EXPECT_FALSE(at(critical + off)) << k;
  }
}

TEST(RaySecondary, GrazingIncidenceHasNoOverflow) {
  V t;
  ASSERT_TRUE(refracted(V{{1, 0, 0}}, V{{0, 1, 0}}, 1.0, 1.5, t));
  EXPECT_NEAR(t.v.x, 1 / 1.5, 1e-15);
}

}  // namespace
}  // namespace sir
