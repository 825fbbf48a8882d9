// The camera that the mouse leads.
#include <numbers>

#include <glm/geometric.hpp>

#include "modeler/orbit.h"
#include "modeler/screen_frame.h"
#include "modeler/view.h"
#include "tests/modeler_fixture.h"
#include "tracer/camera.h"

namespace sir::test {
namespace {

using modeler::Orbit;
using modeler::ScreenFrame;

CameraFile from_front() {
  CameraFile camera;
  camera.target = {1, 2, 3};
  camera.distance = 4;
  camera.focal = 2;
  camera.focal_given = true;
  return camera;
}

class OrbitTest : public ModelerTest {};

TEST_F(OrbitTest, WhatIsSavedIsWhatWasRead) {
  for (const char* name : {"calice", "lcg", "luminar", "piramide", "whitted"}) {
    TextFile file(std::string(SIR_IMAGES "/") + name + ".CAM");
    Orbit orbit(read_camera(file));
    const std::string before = camera_text(orbit.camera());
    orbit.turn(0, 0);
    orbit.pan(0, 0);
    orbit.zoom(0);
    EXPECT_EQ(camera_text(orbit.camera()), before) << name;
    orbit.turn(0.2, -0.1);
    orbit.pan(0.3, 0.1);
    orbit.zoom(2);
    TextFile again("SAVED.CAM", camera_text(orbit.camera()));
    EXPECT_EQ(camera_text(read_camera(again)), camera_text(orbit.camera())) << name;
    EXPECT_NE(camera_text(orbit.camera()), before) << name;
  }
}

TEST_F(OrbitTest, BeginsWithTheWholeSolid) {
  const modeler::Box box{{-1, 0, 2}, {1, 5, 3}};
  EXPECT_EQ(camera_text(Orbit(box, 1.5).camera()), camera_text(modeler::framing(box, 1.5)));
  EXPECT_EQ(Orbit(modeler::Box{}, 2).camera().target, glm::dvec3(0));
}

TEST_F(OrbitTest, HalfATurnForAHeight) {
  Orbit orbit(from_front());
  orbit.turn(0.5, 0);  // the solid's front goes to the right: it is seen from the left
  EXPECT_NEAR(glm::distance(orbit.camera().normal, glm::dvec3(1, 0, 0)), 0, 1e-12);
  orbit.turn(-1, 0);
  EXPECT_NEAR(glm::distance(orbit.camera().normal, glm::dvec3(-1, 0, 0)), 0, 1e-12);
  orbit.turn(0.5, 0.25);  // its top comes to the front: it is seen from above
  EXPECT_NEAR(glm::distance(orbit.camera().normal,
                            glm::dvec3(0, -std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2)),
              0, 1e-12);
  EXPECT_EQ(orbit.camera().target, from_front().target);
  EXPECT_EQ(orbit.camera().distance, from_front().distance);
}

TEST_F(OrbitTest, NeverLooksAlongTheAxis) {
  for (const double down : {30.0, -30.0}) {
    Orbit orbit(from_front());
    orbit.turn(0, down);
    orbit.turn(0.3, 0);
    const double along = glm::dot(orbit.camera().normal, orbit.camera().up);
    EXPECT_LT(std::abs(along), 1 - 1e-5);
    EXPECT_GT(std::abs(along), 0.99);
    EXPECT_EQ(along<0, down> 0);
    const std::string text = camera_text(orbit.camera());
    TextFile file("-", text);
    EXPECT_EQ(camera_text(read_camera(file)), text);
  }
}

TEST_F(OrbitTest, PanningKeepsTheTargetsPlaneUnderTheMouse) {
  for (const bool parallel : {false, true}) {
    CameraFile camera = from_front();
    camera.normal = {0.3, -0.4, -1};
    camera.parallel = parallel;
    Orbit orbit(camera);
    const auto on_screen = [&](const glm::dvec3& point) {
      const glm::dvec3 seen = ScreenFrame(orbit.camera()).observe(point);
      const double shrink = parallel ? 1 : camera.focal / (camera.focal + seen.z);
      return glm::dvec2(seen) * shrink / camera.window;
    };
    const glm::dvec2 before = on_screen(camera.target);
    orbit.pan(0.25, 0.125);
    const glm::dvec2 after = on_screen(camera.target);
    EXPECT_NEAR(after.x - before.x, 0.25, 1e-12);
    EXPECT_NEAR(after.y - before.y, -0.125, 1e-12);
  }
}

TEST_F(OrbitTest, ZoomingIsOfTheWindowAlone) {
  Orbit orbit(from_front());
  orbit.zoom(3);
  EXPECT_NEAR(orbit.camera().window.x, 4 / 1.331, 1e-12);
  orbit.zoom(-3);
  EXPECT_NEAR(orbit.camera().window.y, 3, 1e-12);
  EXPECT_EQ(orbit.camera().distance, from_front().distance);
  orbit.zoom(1e9);
  EXPECT_NEAR(orbit.camera().window.y, 3, 1e-12);
}

TEST_F(OrbitTest, TheFrameIsTheTracers) {
  CameraFile file = from_front();
  file.normal = {0.3, -0.4, -1};
  const ScreenFrame frame(file);
  const Camera<double> camera(file);
  const ImageSize size{7, 5};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec3 seen = frame.observe(camera.primary_ray(x, y, size).at(0.7).v);
      const glm::dvec3 expected = camera.primary_ray_obs(x, y, size).at(0.7).v;
      EXPECT_NEAR(glm::distance(seen, expected), 0, 1e-12);
    }
}

}  // namespace
}  // namespace sir::test
