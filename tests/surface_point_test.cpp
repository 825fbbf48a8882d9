#include "tracer/surface_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sir {
namespace {

using K = PrimitiveKind;

TextureUv<double> uv(K kind, int face, glm::dvec3 p) {
  return texture_uv(kind, face, PointLocal<double>{p});
}
glm::dvec3 normal(K kind, int face, glm::dvec3 p) {
  return glm::normalize(outward_normal(kind, face, PointLocal<double>{p}).v);
}

void expect_uv(TextureUv<double> got, double u, double v) {
  EXPECT_NEAR(got.u, u, 1e-15);
  EXPECT_NEAR(got.v, v, 1e-15);
}

TEST(SurfacePoint, CubeCoordinatesTakeTheOtherTwoAxes) {
  const glm::dvec3 p(0.1, 0.2, 0.3);
  expect_uv(uv(K::cube, 0, p), 0.3, 0.2);  // X=c: (z,y)
  expect_uv(uv(K::cube, 1, p), 0.3, 0.2);
  expect_uv(uv(K::cube, 2, p), 0.1, 0.3);  // Y=c: (x,z)
  expect_uv(uv(K::cube, 3, p), 0.1, 0.3);
  expect_uv(uv(K::cube, 4, p), 0.1, 0.2);  // Z=c: (x,y)
  expect_uv(uv(K::cube, 5, p), 0.1, 0.2);
}

TEST(SurfacePoint, SphereCoordinates) {
  expect_uv(uv(K::sphere, 0, {1, 0, 0}), 0, 0.5);
  expect_uv(uv(K::sphere, 0, {0, 0, 1}), 0.25, 0.5);  // atan2(z,x)
  expect_uv(uv(K::sphere, 0, {-1, 0, 0}), 0.5, 0.5);
  expect_uv(uv(K::sphere, 0, {0, 0, -1}), 0.75, 0.5);    // wrapped, not -0.25
  EXPECT_NEAR(uv(K::sphere, 0, {0, 1, 0}).v, 1, 1e-15);  // acos(-y)/pi
  EXPECT_NEAR(uv(K::sphere, 0, {0, -1, 0}).v, 0, 1e-15);
}

TEST(SurfacePoint, CoordinatesNeverLeaveTheUnitSquare) {
  EXPECT_EQ(uv(K::sphere, 0, {1, 0, -1e-20}).u, 0);  // -1e-20 wraps to 1, which is 0
  EXPECT_EQ(uv(K::sphere, 0, {0, -1 - 1e-15, 0}).v, 0);
  EXPECT_EQ(uv(K::sphere, 0, {0, 1 + 1e-15, 0}).v, 1);
  EXPECT_EQ(uv(K::cube, 0, {0, 1 + 1e-15, -1e-15}).u, 0);
  EXPECT_EQ(uv(K::cube, 0, {0, 1 + 1e-15, -1e-15}).v, 1);
}

TEST(SurfacePoint, SidesAndCaps) {
  expect_uv(uv(K::cylinder, 2, {0, 0.3, 1}), 0.25, 0.3);
  expect_uv(uv(K::cylinder, 0, {0.5, 0, -0.5}), 0.75, 0.25);
  expect_uv(uv(K::cylinder, 1, {-1, 1, 1}), 0, 1);
  expect_uv(uv(K::cone, 0, {-0.5, 0.5, 0}), 0.5, 0.5);
  expect_uv(uv(K::cone, 1, {0.5, 0, -0.5}), 0.75, 0.25);
}

TEST(SurfacePoint, NormalsPointOutwards) {
  const glm::dvec3 axes[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (int face = 0; face < 6; ++face)
    EXPECT_EQ(normal(K::cube, face, {0.5, 0.5, 0.5}), axes[face]);
  EXPECT_EQ(normal(K::sphere, 0, {0, -1, 0}), glm::dvec3(0, -1, 0));
  EXPECT_EQ(normal(K::cylinder, 0, {0.1, 0, 0}), glm::dvec3(0, -1, 0));
  EXPECT_EQ(normal(K::cylinder, 1, {0.1, 1, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(normal(K::cylinder, 2, {0, 0.7, -1}), glm::dvec3(0, 0, -1));
  EXPECT_EQ(normal(K::cone, 1, {0.1, 0, 0}), glm::dvec3(0, -1, 0));
  const glm::dvec3 side = normal(K::cone, 0, {0.5, 0.5, 0});
  EXPECT_NEAR(side.x, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(side.y, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(normal(K::cone, 0, {0, 1, 0}), glm::dvec3(0, 1, 0));  // the apex: the axis
}

TEST(SurfacePoint, OnFaceMeasuresADistance) {
  const auto on = [](K kind, int face, glm::dvec3 p) {
    return on_face(kind, face, PointLocal<double>{p}, 1e-10);
  };
  EXPECT_TRUE(on(K::cube, 3, {0.5, 1 + 5e-11, 1 + 5e-11}));
  EXPECT_FALSE(on(K::cube, 3, {0.5, 1 + 2e-10, 0.5}));
  EXPECT_FALSE(on(K::cube, 3, {0.5, 1, 1.1}));  // its plane, beyond its edge
  EXPECT_FALSE(on(K::cube, 2, {0.5, 1, 0.5}));
  EXPECT_TRUE(on(K::sphere, 0, {0, 0, -1 - 5e-11}));
  EXPECT_FALSE(on(K::sphere, 0, {0, 0, -1 - 2e-10}));
  EXPECT_TRUE(on(K::cylinder, 2, {0.6, 0.9, 0.8}));
  EXPECT_FALSE(on(K::cylinder, 2, {0.6, 9, 0.8}));
  EXPECT_TRUE(on(K::cylinder, 1, {0.9, 1, 0}));
  EXPECT_FALSE(on(K::cylinder, 1, {9, 1, 0}));
  EXPECT_FALSE(on(K::cylinder, 0, {0.9, 1, 0}));
  EXPECT_TRUE(on(K::cone, 0, {0.25, 0.75, 0}));
  EXPECT_FALSE(on(K::cone, 0, {0.25, 0.25, 0}));
  EXPECT_FALSE(on(K::cone, 0, {2, -1, 0}));     // its continuation below the base
  EXPECT_FALSE(on(K::cone, 0, {0.5, 1.5, 0}));  // the upper nappe
  EXPECT_TRUE(on(K::cone, 1, {0.25, 0, 0}));
  EXPECT_FALSE(on(K::cone, 1, {1.25, 0, 0}));
}

}  // namespace
}  // namespace sir
