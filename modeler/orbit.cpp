#include "modeler/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "modeler/screen_frame.h"
#include "modeler/view.h"

namespace sir::modeler {
namespace {

constexpr double kHighest = 89 * std::numbers::pi / 180;
constexpr double kStep = 1.1;
// Of the window's sides, beyond which the numbers would lose their meaning.
constexpr double kLeast = 1e-100, kMost = 1e100;

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

CameraFile framed(const Box& bounds, double aspect) {
  return framing(can_be_framed(bounds) ? bounds : Box{glm::dvec3(-1), glm::dvec3(1)}, aspect);
}

}  // namespace

Orbit::Orbit(const CameraFile& camera) : camera_(camera) {}

Orbit::Orbit(const Box& bounds, double aspect) : camera_(framed(bounds, aspect)) {}

void Orbit::turn(double right, double down) {
  if (right == 0 && down == 0) return;
  const glm::dvec3 axis = glm::normalize(scaled_near_one(camera_.up));
  const ScreenFrame frame(camera_);
  // Level is across the axis and the screen's right, whatever the camera looks along.
  const glm::dvec3 level = turned(glm::cross(axis, frame.right), axis, -std::numbers::pi * right);
  const double now = std::atan2(glm::dot(frame.normal, axis),
                                glm::dot(frame.normal, glm::cross(axis, frame.right)));
  const double limit = std::max(kHighest, std::abs(now));
  const double height = std::clamp(now - std::numbers::pi * down, -limit, limit);
  camera_.normal = std::cos(height) * level + std::sin(height) * axis;
}

void Orbit::pan(double right, double down) {
  if (right == 0 && down == 0) return;
  const ScreenFrame frame(camera_);
  // What is one window wide on the screen is so much wider at the target.
  const double widening = camera_.parallel ? 1 : 1 + camera_.distance / camera_.focal;
  camera_.target -=
      widening * (right * camera_.window.x * frame.right - down * camera_.window.y * frame.up);
}

void Orbit::zoom(double steps) {
  const glm::dvec2 window = camera_.window * std::pow(kStep, -steps);
  const auto usable = [](double side) { return side > kLeast && side < kMost; };
  if (usable(window.x) && usable(window.y)) camera_.window = window;
}

}  // namespace sir::modeler
