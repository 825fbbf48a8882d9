// .CAM and .LUZ (thesis 3.6.2, 3.6.3).
#include <algorithm>

#include <glm/geometric.hpp>

#include "tracer/numeric.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

glm::dvec3 read_vector(TextFile& file, std::string_view what) {
  std::array<double, 3> v{};
  file.read_numbers(what, v);
  return {v[0], v[1], v[2]};
}

void refuse_negative(const TextFile& file, std::string_view what, const glm::dvec3& v) {
  if (v.x < 0 || v.y < 0 || v.z < 0) file.fail(std::string(what) + " must not be negative");
}

bool are_parallel(const glm::dvec3& a, const glm::dvec3& b) {
  const auto u = scaled_near_one(a), v = scaled_near_one(b);
  constexpr double kRoundings = 4;
  return glm::length(glm::cross(u, v)) <=
         kRoundings * Numeric<double>::kEpsilon * glm::length(u) * glm::length(v);
}

}  // namespace

CameraFile read_camera(TextFile& file) {
  CameraFile camera;
  std::array<double, 2> window{};
  file.read_numbers("window width and height", window);
  if (!(window[0] > 0 && window[1] > 0)) file.fail("the window's width and height must be > 0");
  camera.window = {window[0], window[1]};
  camera.target = read_vector(file, "target");
  camera.normal = read_vector(file, "normal direction");
  if (camera.normal == glm::dvec3(0)) file.fail("the normal direction must not be zero");
  file.read_numbers("distance between camera and target", std::span(&camera.distance, 1));
  if (camera.distance < 0) file.fail("the distance between camera and target must not be negative");
  const std::size_t distance_line = file.line_number();
  camera.up = read_vector(file, "up vector");
  if (camera.up == glm::dvec3(0) || are_parallel(camera.up, camera.normal))
    file.fail("the up vector must not be zero or parallel to the normal direction");
  camera.focal = camera.distance;
  if (file.next()) {
    if (fold_keyword(file.line()) == "paralela") {
      camera.parallel = true;
    } else {
      const auto focal = file.numbers_here("focal distance (or PARALELA)");
      if (focal.size() != 1 || !(focal[0] > 0))
        file.fail("the focal distance must be one number > 0, or PARALELA");
      camera.focal = focal[0];
      camera.focal_given = true;
    }
    if (file.next()) file.fail("the camera has five lines and at most a sixth; this is one more");
  } else if (!(camera.distance > 0)) {
    file.fail_at(distance_line,
                 "the distance is 0: a sixth line must give a focal distance or PARALELA");
  }
  return camera;
}

Lighting read_lighting(TextFile& file) {
  Lighting lighting;
  lighting.background = read_vector(file, "background colour");
  refuse_negative(file, "background colour", lighting.background);

  file.expect("ambient light");
  const auto ambient = file.numbers_here("ambient light");
  if (ambient.size() == 1) lighting.ambient = glm::dvec3(ambient[0]);
  else if (ambient.size() == 3) lighting.ambient = {ambient[0], ambient[1], ambient[2]};
  else
    file.fail("ambient light: one number or three expected, " + std::to_string(ambient.size()) +
              " found");
  refuse_negative(file, "ambient light", lighting.ambient);

  const auto announced = file.read_count("the number of lights");
  require_at_most(file, announced, "lights");
  constexpr std::size_t kLeastBytes = 8;  // a light has more
  lighting.lights.reserve(std::min(static_cast<std::size_t>(announced), file.size() / kLeastBytes));
  for (std::int64_t i = 0; i < announced; ++i) {
    if (file.at_end())
      file.fail("the file announces " + counted(announced, "light") + " and ends after " +
                std::to_string(i));
    file.next();
    const std::string what = "light " + std::to_string(i + 1);
    const auto v = file.numbers_here(what);
    if (v.size() != 6 && v.size() != 4)
      file.fail(what + ": x y z r g b or x y z i expected, " + std::to_string(v.size()) +
                " numbers found");
    Light light;
    light.position = {v[0], v[1], v[2]};
    light.intensity = v.size() == 6 ? glm::dvec3(v[3], v[4], v[5]) : glm::dvec3(v[3]);
    refuse_negative(file, what + "'s intensity", light.intensity);
    lighting.lights.push_back(light);
  }
  if (file.next()) file.fail("the file announces " + counted(announced, "light") + " and goes on");
  return lighting;
}

}  // namespace sir
