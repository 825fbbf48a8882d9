#include "modeler/view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "modeler/csg.h"
#include "modeler/screen_frame.h"

namespace sir::modeler {
namespace {

constexpr glm::dvec3 kDirection(-0.5, -0.5, -1);
constexpr double kMargin = 1.1;  // 5 % on each side

// A hue of its own for each number: turned by the golden angle from one to the next.
glm::dvec3 hue_of(std::int64_t number) {
  const double turn = std::fmod(static_cast<double>(number % 100003) * 0.618033988749895, 1.0);
  glm::dvec3 colour;
  for (int primary = 0; primary < 3; ++primary) {
    const double around = std::fmod(turn + (3 - primary) / 3.0, 1.0);
    colour[primary] = std::clamp(std::abs(6 * around - 3) - 1, 0.0, 1.0);
  }
  return 0.35 + 0.5 * colour;
}

}  // namespace

bool can_be_framed(const Box& bounds) {
  constexpr double kFarthest = 1e300;  // far from where sums become infinite
  if (is_empty(bounds)) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (bounds.low[axis] < -kFarthest || bounds.high[axis] > kFarthest) return false;
  return true;
}

CameraFile framing(const Box& bounds, double aspect) {
  CameraFile camera;
  const glm::dvec3 half = bounds.high / 2.0 - bounds.low / 2.0;
  // Squares of what is very large or small are no numbers.
  const double radius =
      std::max(std::hypot(half.x, half.y, half.z), std::numeric_limits<double>::min());
  camera.target = bounds.centre();
  camera.normal = kDirection;
  camera.distance = radius;  // the screen touches the sphere around the box
  camera.focal = 3 * radius;
  camera.focal_given = true;
  const ScreenFrame frame(camera);
  double width = 0, height = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = (corner >> axis & 1) != 0 ? bounds.high[axis] : bounds.low[axis];
    const glm::dvec3 seen = frame.observe(point);
    const double shrink = camera.focal / (camera.focal + seen.z);
    width = std::max(width, 2 * std::abs(seen.x) * shrink);
    height = std::max(height, 2 * std::abs(seen.y) * shrink);
  }
  camera.window.y = kMargin * std::max({height, width / aspect, radius * 1e-6});
  camera.window.x = aspect * camera.window.y;
  return camera;
}

std::vector<Box> bounds_in_obs(const Node& tree, const CameraFile& camera) {
  const ScreenFrame frame(camera);
  const glm::dmat3 turn = frame.turn();
  const std::vector<const Node*> nodes = preorder(tree);
  std::vector<Box> boxes(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (const Primitive* primitive = nodes[i]->primitive()) {
      LocalCena<double> local_obs;
      local_obs.linear = turn * primitive->local_cena.linear;
      local_obs.translation = frame.observe(primitive->local_cena.translation);
      boxes[i] = tight_bounds_of(primitive->kind, local_obs);
    } else {
      const Composite& composite = *nodes[i]->composite();
      boxes[i] = combined(composite.operation, boxes[i + 1], boxes[i + 1 + composite.left->count]);
    }
  }
  return boxes;
}

Region pixels_of(const Box& in_obs, const CameraFile& camera, ImageSize size) {
  if (is_empty(in_obs)) return {};
  const double focal = camera.focal;
  if (!camera.parallel && !(in_obs.low.z > -0.999 * focal)) return {0, 0, size.width, size.height};
  // What is nearer is seen larger.
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const double x : {in_obs.low.x, in_obs.high.x})
    for (const double y : {in_obs.low.y, in_obs.high.y})
      for (const double z : {in_obs.low.z, in_obs.high.z}) {
        const glm::dvec2 seen = glm::dvec2(x, y) * (camera.parallel ? 1 : focal / (focal + z));
        low = glm::min(low, seen);
        high = glm::max(high, seen);
      }
  // A pixel more on each side for rounding.
  const auto column = [&](double x) { return (x / camera.window.x + 0.5) * size.width; };
  const auto row = [&](double y) { return (0.5 - y / camera.window.y) * size.height; };
  const auto within = [](double at, int count) {
    return static_cast<int>(std::clamp(at, 0.0, double(count)));
  };
  Region region;
  region.x = within(std::floor(column(low.x)) - 1, size.width);
  region.y = within(std::floor(row(high.y)) - 1, size.height);
  region.width = within(std::ceil(column(high.x)) + 1, size.width) - region.x;
  region.height = within(std::ceil(row(low.y)) + 1, size.height) - region.y;
  return region;
}

Surface made_up_surface(std::int64_t number) {
  Surface surface;
  surface.number = number;
  surface.name = "surface " + std::to_string(number);
  surface.first.ambient = surface.first.diffuse = hue_of(number);
  surface.first.specular = 0.15;
  surface.first.exponent = 20;
  return surface;
}

Lighting made_up_lighting(const CameraFile& camera) {
  const ScreenFrame frame(camera);
  Lighting lighting;
  lighting.background = {0.12, 0.14, 0.18};
  lighting.ambient = glm::dvec3(0.35);
  // What is very far away stays a number.
  constexpr double kMost = std::numeric_limits<double>::max();
  const double far = std::min(10 * (camera.distance + camera.focal), 1e300);
  lighting.lights.push_back(
      {glm::clamp(frame.origin + far * frame.turned_back({-0.6, 0.8, -1}), -kMost, kMost),
       glm::dvec3(0.8)});
  return lighting;
}

Scene scene_of(const Node& tree, const CameraFile& camera) {
  Scene scene;
  scene.tree = to_csg(tree);
  scene.camera = camera;
  std::set<std::int64_t> numbers;
  for (const CsgNode& node : scene.tree.nodes)
    if (!node.composite)
      numbers.insert(node.surfaces.begin(), node.surfaces.begin() + face_count(node.kind));
  for (const std::int64_t number : numbers) scene.surfaces.push_back(made_up_surface(number));
  scene.lighting = made_up_lighting(camera);
  return scene;
}

void dress(Scene& scene, const std::optional<Lighting>& lighting,
           const std::vector<Surface>& described) {
  if (lighting) scene.lighting = *lighting;
  for (const Surface& known : described)
    for (Surface& surface : scene.surfaces)
      if (surface.number == known.number) surface = known;
}

}  // namespace sir::modeler
