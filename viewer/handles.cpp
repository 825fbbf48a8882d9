#include "viewer/handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sir::viewer {
namespace {

// An axis that is seen so short, in parts of its length, points at the observer.
constexpr double kShortest = 0.12;
// A plane is seen from its edge where rays meet it at less than this sine.
constexpr double kEdgeOn = 0.15;
constexpr int kArcSteps = 48;

glm::dvec3 unit(int axis) {
  glm::dvec3 vector(0);
  vector[axis] = 1;
  return vector;
}

double rounded(double value, double step) {
  // Through the step's inverse where it is below 1: 0.1 is no power of two, 10 is exact.
  return step < 1 ? std::round(value * std::round(1 / step)) / std::round(1 / step)
                  : std::round(value / step) * step;
}

double distance_to(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 way = b - a;
  const double square = glm::dot(way, way);
  const double part = square > 0 ? std::clamp(glm::dot(point - a, way) / square, 0.0, 1.0) : 0;
  return glm::length(point - a - part * way);
}

}  // namespace

Handles::Handles(HandleKind kind, const glm::dvec3& centre, const CameraFile& camera,
                 ImageSize size, double length)
    : kind_(kind),
      centre_(centre),
      camera_(camera),
      size_(size),
      frame_(camera),
      rays_(camera),
      length_(length) {
  const auto middle = seen(centre);
  if (!middle) return;
  middle_ = *middle;
  const double depth = frame_.observe(centre).z;
  unit_ =
      camera.window.y / size.height * (camera.parallel ? 1 : (camera.focal + depth) / camera.focal);
  for (int axis = 0; axis < 3; ++axis) {
    if (kind == HandleKind::turn) add_arc(axis);
    else add_line(axis);
  }
  if (kind != HandleKind::turn) all_.push_back({Handle::kAll, {middle_}});
}

std::optional<glm::dvec2> Handles::seen(const glm::dvec3& point) const {
  const glm::dvec3 at = frame_.observe(point);
  // A hundredth of the way from the eye to the screen: nearer, places run off to the infinite.
  if (!camera_.parallel && !(at.z > -0.99 * camera_.focal)) return std::nullopt;
  const double shrink = camera_.parallel ? 1 : camera_.focal / (camera_.focal + at.z);
  return glm::dvec2((at.x * shrink / camera_.window.x + 0.5) * size_.width,
                    (0.5 - at.y * shrink / camera_.window.y) * size_.height);
}

void Handles::add_line(int axis) {
  const auto grip = seen(centre_ + length_ * unit_ * unit(axis));
  if (!grip || glm::length(*grip - middle_) < kShortest * length_) return;
  all_.push_back({axis, {middle_, *grip}});
}

glm::dvec3 Handles::on_ring(int axis, double angle) const {
  return centre_ +
         length_ * unit_ *
             (std::cos(angle) * unit((axis + 1) % 3) + std::sin(angle) * unit((axis + 2) % 3));
}

// The half that is in front of the other; all of it where it is seen from above.
void Handles::add_arc(int axis) {
  const glm::dvec3 ray = rays_.ray_through(middle_.x, middle_.y, size_).direction.v;
  const glm::dvec3 towards = -glm::normalize(ray);
  const double u = towards[(axis + 1) % 3], v = towards[(axis + 2) % 3];
  const bool whole = std::hypot(u, v) < kShortest;
  const double middle = std::atan2(v, u), half = std::numbers::pi * (whole ? 1 : 0.5);
  Handle handle{axis, {}};
  for (int step = 0; step <= kArcSteps; ++step) {
    const auto point = seen(on_ring(axis, middle + half * (2.0 * step / kArcSteps - 1)));
    if (!point) return;
    handle.line.push_back(*point);
  }
  all_.push_back(std::move(handle));
}

std::optional<int> Handles::at(const glm::dvec2& point, double reach) const {
  std::optional<int> found;
  double nearest = reach;
  for (const Handle& handle : all_) {
    if (handle.axis == Handle::kAll) {
      // Lines begin under it.
      if (glm::length(point - middle_) <= reach) return handle.axis;
      continue;
    }
    for (std::size_t i = 1; i < handle.line.size(); ++i) {
      const double distance = distance_to(point, handle.line[i - 1], handle.line[i]);
      if (distance > nearest) continue;
      nearest = distance;
      found = handle.axis;
    }
  }
  return found;
}

// Where the axis comes nearest to the ray; none where they are all but parallel, or meet behind the
// screen's near side.
std::optional<double> Handles::on_axis(int axis, const glm::dvec2& at) const {
  const auto ray = rays_.ray_through(at.x, at.y, size_);
  const glm::dvec3 origin = ray.origin.v, direction = ray.direction.v;
  const glm::dvec3 way = centre_ - origin;
  const double b = direction[axis], d = glm::dot(direction, direction);
  const double square = d - b * b;
  if (square < kEdgeOn * kEdgeOn * d) return std::nullopt;
  const double s = (b * glm::dot(direction, way) - d * way[axis]) / square;
  const double t = (glm::dot(direction, way) + s * b) / d;
  return camera_.parallel || t > -0.99 ? std::optional(s) : std::nullopt;
}

double Handles::along(int axis, const glm::dvec2& from, const glm::dvec2& to) const {
  const auto first = on_axis(axis, from), last = on_axis(axis, to);
  if (first && last) return *last - *first;
  // As far as the mouse has gone along the line.
  const auto grip = seen(centre_ + length_ * unit_ * unit(axis));
  if (!grip) return 0;
  const glm::dvec2 line = *grip - middle_;
  const double square = glm::dot(line, line);
  return square > 0 ? length_ * unit_ * glm::dot(to - from, line) / square : 0;
}

glm::dvec3 Handles::moved(int axis, const glm::dvec2& from, const glm::dvec2& to) const {
  const double step = std::pow(10.0, std::floor(std::log10(unit_)));
  const glm::dvec2 way = (to - from) * unit_;
  const glm::dvec3 amount = axis == Handle::kAll ? way.x * frame_.right - way.y * frame_.up
                                                 : along(axis, from, to) * unit(axis);
  return {rounded(amount.x, step), rounded(amount.y, step), rounded(amount.z, step)};
}

std::optional<double> Handles::angle(int axis, const glm::dvec2& at) const {
  const auto ray = rays_.ray_through(at.x, at.y, size_);
  const glm::dvec3 origin = ray.origin.v, direction = ray.direction.v;
  if (std::abs(direction[axis]) < kEdgeOn * glm::length(direction)) return std::nullopt;
  const double t = (centre_ - origin)[axis] / direction[axis];
  const glm::dvec3 point = origin + t * direction - centre_;
  return std::atan2(point[(axis + 2) % 3], point[(axis + 1) % 3]);
}

double Handles::turned(int axis, const glm::dvec2& from, const glm::dvec2& to) const {
  const auto first = angle(axis, from), last = angle(axis, to);
  double radians = 0;
  if (first && last) {
    radians = *last - *first;
  } else {
    // From its edge a ring is a line: the mouse pulls its near side along.
    const glm::dvec3 ray = rays_.ray_through(middle_.x, middle_.y, size_).direction.v;
    const double near = std::atan2(-ray[(axis + 2) % 3], -ray[(axis + 1) % 3]);
    constexpr double kLittle = 0.01;
    const auto before = seen(on_ring(axis, near - kLittle)),
               after = seen(on_ring(axis, near + kLittle));
    if (!before || !after) return 0;
    const glm::dvec2 pull = (*after - *before) / (2 * kLittle);
    radians = glm::dot(to - from, pull) / glm::dot(pull, pull);
  }
  double degrees = std::remainder(std::round(radians * 180 / std::numbers::pi), 360);
  if (degrees <= -180) degrees += 360;
  return degrees + 0.0;  // never -0
}

glm::dvec3 Handles::scaled(int axis, const glm::dvec2& from, const glm::dvec2& to) const {
  const auto factor = [](double value) {
    return std::isfinite(value) ? std::clamp(rounded(value, 0.01), 0.01, 1000.0) : 1;
  };
  // The grip in the middle: twice as large for a handle's length to the right, or up.
  if (axis == Handle::kAll)
    return glm::dvec3(factor(std::exp2((to.x - from.x - to.y + from.y) / length_)));
  const double before = on_axis(axis, from).value_or(length_ * unit_);
  glm::dvec3 factors(1);
  factors[axis] = factor(1 + along(axis, from, to) / before);
  return factors;
}

}  // namespace sir::viewer
