#include "tracer/camera.h"

#include <gtest/gtest.h>

namespace sir {
namespace {

CameraFile looking_down_minus_z() {
  CameraFile file;
  file.window = {4, 3};
  file.target = {1, 2, 3};
  file.normal = {0, 0, -2};  // any length
  file.distance = 5;
  file.up = {0, 3, 0};
  file.focal = 5;
  return file;
}

TEST(Camera, CentreOfAnOddImageLooksAtTheTarget) {
  const Camera<double> camera(looking_down_minus_z());
  const auto ray = camera.primary_ray(1, 1, {3, 3});
  EXPECT_EQ(ray.origin.v, glm::dvec3(1, 2, 8));  // target - d n
  EXPECT_EQ(ray.direction.v, glm::dvec3(0, 0, -5));
  EXPECT_EQ(ray.at(1).v, glm::dvec3(1, 2, 3));
}

// On sizes of every parity, small, odd, large and lopsided.
TEST(Camera, RaysThroughPixelCentresArePrimaryRaysToTheBit) {
  CameraFile file = looking_down_minus_z();
  file.normal = {-0.3, -0.41, -0.97};
  file.window = {1.7, 1.3};
  const auto check = [&]<typename T>(const Camera<T>& camera) {
    for (const ImageSize size : {ImageSize{1, 1},
                                 {1, 9},
                                 {17, 31},
                                 {640, 480},
                                 {1021, 763},
                                 {4096, 3},
                                 {16384, 16384},
                                 {1 << 28, 1},
                                 {1, (1 << 28) - 1}})
      for (int n = 0; n <= 40; ++n) {
        const int i = static_cast<int>(std::int64_t{size.width - 1} * n / 40);
        const int j = static_cast<int>(std::int64_t{size.height - 1} * (40 - n) / 40);
        const auto pixel = camera.primary_ray(i, j, size);
        const auto point = camera.ray_through(i + 0.5, j + 0.5, size);
        ASSERT_EQ(point.origin.v, pixel.origin.v) << i << " " << j;
        ASSERT_EQ(point.direction.v, pixel.direction.v) << i << " " << j;
        // The formula of section 2.3.3 in integers, as it was before there were points.
        const T xp = T(file.window.x) * T(2 * i + 1 - size.width) / T(2 * size.width);
        const T yp = T(file.window.y) * T(size.height - 2 * j - 1) / T(2 * size.height);
        const auto obs = camera.primary_ray_obs(i, j, size);
        ASSERT_EQ(obs.origin.v, (glm::vec<3, T>(xp, yp, 0))) << i << " " << j;
      }
  };
  check(Camera<double>(file));
  check(Camera<float>(file));
}

TEST(Camera, CornersOfTheScreenAreThoseOfTheWindow) {
  const Camera<double> camera(looking_down_minus_z());
  const glm::dvec3 centre(1, 2, 8);
  EXPECT_EQ(camera.ray_through(0, 0, {640, 480}).origin.v, centre + glm::dvec3(-2, 1.5, 0));
  EXPECT_EQ(camera.ray_through(640, 480, {640, 480}).origin.v, centre + glm::dvec3(2, -1.5, 0));
  EXPECT_EQ(camera.ray_through(320, 240, {640, 480}).origin.v, centre);
}

TEST(Camera, ColumnsGoRightAndRowsGoDown) {
  const Camera<double> camera(looking_down_minus_z());
  // right = n x up = (0,0,-1) x (0,1,0) = (1,0,0); the pixel's centre in a
  // 4x3 image of a 4x3 window lies half a unit from the window's corner.
  const auto ray = camera.primary_ray(0, 0, {4, 3});
  EXPECT_EQ(ray.origin.v, glm::dvec3(1 - 1.5, 2 + 1, 8));
  EXPECT_EQ(ray.direction.v, glm::dvec3(-1.5, 1, -5));
  const auto last = camera.primary_ray(3, 2, {4, 3});
  EXPECT_EQ(last.origin.v, glm::dvec3(1 + 1.5, 2 - 1, 8));
}

TEST(Camera, ParallelRaysHaveTheNormalsDirection) {
  CameraFile file = looking_down_minus_z();
  file.parallel = true;
  const Camera<double> camera(file);
  const auto ray = camera.primary_ray(0, 0, {4, 3});
  EXPECT_EQ(ray.origin.v, glm::dvec3(-0.5, 3, 8));
  EXPECT_EQ(ray.direction.v, glm::dvec3(0, 0, -1));
}

TEST(Camera, FocalDistanceOtherThanTheTargets) {
  CameraFile file = looking_down_minus_z();
  file.focal = 2;
  const auto ray = Camera<double>(file).primary_ray(0, 0, {4, 3});
  EXPECT_EQ(ray.direction.v, glm::dvec3(-1.5, 1, -2));
  EXPECT_EQ(ray.origin.v, glm::dvec3(-0.5, 3, 8));
}

TEST(Camera, TiltedUpIsMadeUpright) {
  CameraFile file = looking_down_minus_z();
  file.normal = {0, 0, -1};
  file.up = {0, 1, -7};  // leans along the normal
  const auto ray = Camera<double>(file).primary_ray(0, 0, {4, 3});
  EXPECT_EQ(ray.direction.v, glm::dvec3(-1.5, 1, -5));
}

TEST(Camera, ExtremeLengthsOfNormalAndUpChangeNothing) {
  CameraFile file = looking_down_minus_z();
  file.normal *= 1e-200;
  file.up *= 1e200;
  const auto ray = Camera<double>(file).primary_ray(3, 1, {4, 3});
  const auto usual = Camera<double>(looking_down_minus_z()).primary_ray(3, 1, {4, 3});
  EXPECT_EQ(ray.origin.v, usual.origin.v);
  EXPECT_EQ(ray.direction.v, usual.direction.v);
}

TEST(Camera, ObserverFrameIsTheThesisOne) {
  const auto ray = Camera<double>(looking_down_minus_z()).primary_ray_obs(3, 0, {4, 3});
  EXPECT_EQ(ray.origin.v, glm::dvec3(1.5, 1, 0));
  EXPECT_EQ(ray.direction.v, glm::dvec3(1.5, 1, 5));
}

}  // namespace
}  // namespace sir
