#include "interchange/pov_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "tracer/bounds.h"
#include "tracer/numeric.h"

namespace sir {
namespace {

// SC_OBS in SC_CENA, as Camera has it.
struct Observer {
  glm::dvec3 right, up, normal, screen;

  explicit Observer(const CameraFile& file) {
    normal = glm::normalize(scaled_near_one(file.normal));
    right = glm::normalize(glm::cross(normal, scaled_near_one(file.up)));
    up = glm::cross(right, normal);
    screen = file.target - file.distance * normal;
  }
};

Bounds<double> envelope(const CsgNode& primitive) {
  LocalCena<double> placement;
  placement.linear = primitive.placement.linear;
  placement.translation = primitive.placement.translation;
  return bounds_of(primitive.kind, placement);
}

// The primitive's box in SC_LOCAL, corner by corner (bit k: the high end of
// axis k), in SC_OBS.
std::array<glm::dvec3, 8> corners_obs(const CsgNode& node, const Observer& observer) {
  glm::dvec3 low(-1), high(1);
  if (node.kind == PrimitiveKind::cube) low = glm::dvec3(0);
  else if (node.kind != PrimitiveKind::sphere) low.y = 0;
  std::array<glm::dvec3, 8> corners;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = (corner >> axis & 1) != 0 ? high[axis] : low[axis];
    const glm::dvec3 d = node.placement.linear * p + (node.placement.translation - observer.screen);
    corners[static_cast<std::size_t>(corner)] = {
        glm::dot(d, observer.right), glm::dot(d, observer.up), glm::dot(d, observer.normal)};
  }
  return corners;
}

// Whether the primitive has the eye and the screen inside: being convex, it has
// no surface between them.
bool holds_eye_and_screen(const CsgNode& node, const Observer& observer, const CameraFile& file) {
  Inverse inverse;
  if (!invert(node.placement.linear, inverse)) return false;
  const auto inside = [&](const glm::dvec3& point) {
    const glm::dvec3 p =
        (inverse.numerators * (point - node.placement.translation)) / inverse.divisors;
    const double radius = std::hypot(p.x, p.z);
    switch (node.kind) {
      case PrimitiveKind::cube: return glm::all(glm::equal(glm::clamp(p, 0.0, 1.0), p));
      case PrimitiveKind::sphere: return glm::length(p) < 1;
      case PrimitiveKind::cone: return p.y > 0 && radius < 1 - p.y;
      case PrimitiveKind::cylinder: return p.y > 0 && p.y < 1 && radius < 1;
    }
    return false;
  };
  if (!inside(observer.screen - file.focal * observer.normal)) return false;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      if (!inside(observer.screen + x * file.window.x * observer.right +
                  y * file.window.y * observer.up))
        return false;
  return true;
}

// Keeps of a convex polygon what lies where inside(p) >= 0 (Sutherland, Hodgman
// 1974).
template <typename Inside>
std::vector<glm::dvec3> cut(const std::vector<glm::dvec3>& polygon, Inside inside) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = inside(a), db = inside(b);
    if (da >= 0) kept.push_back(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

// Whether the box and the pyramid from the eye to the screen meet: a face of
// the box reaches into the pyramid, or the whole pyramid lies within the box.
bool meets_pyramid(const std::array<glm::dvec3, 8>& box, const CameraFile& file) {
  const auto width = [&](double z) { return file.window.x / 2 * (z / file.focal + 1); };
  const auto height = [&](double z) { return file.window.y / 2 * (z / file.focal + 1); };
  const glm::dvec3 eye(0, 0, -file.focal);
  bool eye_within = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t a = std::size_t{1} << (axis + 1) % 3, b = std::size_t{1} << (axis + 2) % 3;
    const glm::dvec3 across = glm::cross(box[a] - box[0], box[b] - box[0]);
    const std::size_t opposite = std::size_t{1} << axis;
    const double height_of_box = glm::dot(across, box[opposite] - box[0]);
    const double height_of_eye = glm::dot(across, eye - box[0]);
    eye_within = eye_within && height_of_eye * height_of_box >= 0 &&
                 std::abs(height_of_eye) <= std::abs(height_of_box);
    for (const std::size_t end : {std::size_t{0}, opposite}) {
      std::vector<glm::dvec3> face{box[end], box[end + a], box[end + a + b], box[end + b]};
      face = cut(face, [](const glm::dvec3& p) { return -p.z; });
      face = cut(face, [&](const glm::dvec3& p) { return width(p.z) - p.x; });
      face = cut(face, [&](const glm::dvec3& p) { return width(p.z) + p.x; });
      face = cut(face, [&](const glm::dvec3& p) { return height(p.z) - p.y; });
      face = cut(face, [&](const glm::dvec3& p) { return height(p.z) + p.y; });
      if (!face.empty()) return true;
    }
  }
  return eye_within;
}

}  // namespace

std::string pov_vector(const glm::dvec3& vector) {
  const glm::dvec3 v = vector + 0.0;  // -0 becomes 0
  return fmt::format("<{:.17g},{:.17g},{:.17g}>", v.x, v.y, v.z);
}

PovFrame fitting_frame(const Scene& scene) {
  const Observer observer(scene.camera);
  Bounds<double> box;
  for (const CsgNode& node : scene.tree.nodes)
    if (!node.composite) box.include(envelope(node));
  const glm::dvec3 eye = observer.screen - scene.camera.focal * observer.normal;
  box.include({observer.screen, observer.screen});
  if (!scene.camera.parallel) box.include({eye, eye});
  const double diagonal = glm::length(box.high - box.low);
  int exponent = 0;
  std::frexp(diagonal, &exponent);  // diagonal = f 2^exponent, f in [1/2, 1)
  const double unit = std::ldexp(1.0, exponent);
  PovFrame frame;
  for (int axis = 0; axis < 3; ++axis)
    frame.centre[axis] = unit * std::round(box.centre()[axis] / unit);
  frame.factor = std::ldexp(1.0, 20 - exponent);
  return frame;
}

std::string pov_view(const Scene& scene, const PovFrame& frame) {
  const CameraFile& file = scene.camera;
  const Observer observer(file);
  // POV-Ray's ray: location + t (direction + x right + y up), x and y in
  // [-1/2,1/2]. The vectors are taken as they stand; its habit of a left-handed
  // frame is a habit of angle and look_at, which are not used.
  const glm::dvec3 location =
      file.parallel ? observer.screen : observer.screen - file.focal * observer.normal;
  const double ahead = file.parallel ? 1 : file.focal;
  const double across = file.parallel ? frame.factor : 1;  // only ratios count for the other
  std::string text = fmt::format(
      "camera {{\n  {}\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n",
      file.parallel ? "orthographic" : "perspective", pov_vector(frame.apply(location)),
      pov_vector(ahead * observer.normal), pov_vector(file.window.x * across * observer.right),
      pov_vector(file.window.y * across * observer.up));
  const Lighting& lighting = scene.lighting;
  text += fmt::format("background {{ rgb {} }}\n", pov_vector(lighting.background));
  for (const Light& light : lighting.lights)
    text += fmt::format("light_source {{ {} rgb {} }}\n", pov_vector(frame.apply(light.position)),
                        pov_vector(light.intensity));
  return text;
}

bool reaches_before_screen(const Scene& scene) {
  if (scene.camera.parallel) return false;  // POV-Ray's rays begin on the screen too
  const Observer observer(scene.camera);
  return std::any_of(scene.tree.nodes.begin(), scene.tree.nodes.end(), [&](const CsgNode& node) {
    return !node.composite && !holds_eye_and_screen(node, observer, scene.camera) &&
           meets_pyramid(corners_obs(node, observer), scene.camera);
  });
}

std::string pov_half_space_of_scene(const Scene& scene, const PovFrame& frame) {
  const Observer observer(scene.camera);
  // A plane's inside is where n.p < d.
  return fmt::format("plane {{ {}, {:.17g} }}", pov_vector(-observer.normal),
                     glm::dot(-observer.normal, frame.apply(observer.screen)));
}

}  // namespace sir
