#include "bench/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>

namespace sir::bench {
namespace {

constexpr int kSurfaces = 12;
constexpr double kHigh = 1.3;  // the cutting cube is [0, kHigh]^3

// A part of the root union: A, A - B, A - B - C or A n B.
struct Part {
  std::size_t node;
  glm::dvec3 centre;
  double reach;  // nothing of it is farther from its centre
};

class Maker {
 public:
  explicit Maker(const MadeScene& wanted)
      : wanted_(wanted), size_(1.1 / std::cbrt(static_cast<double>(wanted.primitives))) {}

  Scene make();

 private:
  // Not std::uniform_real_distribution, whose numbers are each library's own.
  double any(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random_() >> 11), -53);
  }
  glm::dvec3 any_point(double half) {
    const double x = any(-half, half), y = any(-half, half);
    return {x, y, any(-half, half)};
  }
  glm::dvec3 any_direction();
  std::size_t add_primitive(glm::dvec3 centre, double radius);
  std::size_t add_composite(Operation operation, std::size_t left, std::size_t right);
  std::size_t add_cutting_cube();
  Part add_part(int primitives, bool intersection);
  void add_parts();
  std::size_t join(std::span<Part> parts);
  void look();

  MadeScene wanted_;
  double size_;
  std::mt19937_64 random_{1989};
  Scene scene_;
  std::vector<Part> parts_;
};

glm::dvec3 Maker::any_direction() {
  for (;;) {
    const glm::dvec3 d = any_point(1);
    const double size = glm::length(d);
    if (size > 0.1 && size < 1) return d / size;
  }
}

// One that fills a ball of that radius about the centre fairly well and stays within it.
std::size_t Maker::add_primitive(glm::dvec3 centre, double radius) {
  CsgNode node;
  node.number = static_cast<std::int64_t>(scene_.tree.nodes.size());
  node.name = "p" + std::to_string(node.number);
  node.kind = wanted_.spheres ? PrimitiveKind::sphere : static_cast<PrimitiveKind>(random_() % 4);
  node.surfaces.fill(1 + static_cast<std::int64_t>(random_() % kSurfaces));
  glm::dmat3 axes(radius);
  if (!wanted_.spheres) {
    const glm::dvec3 a = any_direction(), other = any_direction();
    const glm::dvec3 b = glm::normalize(glm::cross(a, other));
    axes = glm::dmat3(a, b, glm::cross(a, b));
    // Half the diagonal of a unit cube is 0.87; a cone or cylinder of radius 0.7 and height 1.4
    // lies in the unit ball.
    const bool cube = node.kind == PrimitiveKind::cube;
    const double scale[] = {1.15, 0.95, 0.7, 0.7};
    const double s = radius * scale[static_cast<int>(node.kind)];
    for (int i = 0; i < 3; ++i) axes[i] *= s * any(0.8, 1);
    if (!cube && node.kind != PrimitiveKind::sphere) axes[1] *= 2.0;
    const glm::dvec3 middle = cube                                 ? glm::dvec3(0.5)
                              : node.kind == PrimitiveKind::sphere ? glm::dvec3(0)
                                                                   : glm::dvec3(0, 0.5, 0);
    centre -= axes * middle;
  }
  node.placement.linear = axes;
  node.placement.translation = centre;
  scene_.tree.nodes.push_back(node);
  return scene_.tree.nodes.size() - 1;
}

std::size_t Maker::add_composite(Operation operation, std::size_t left, std::size_t right) {
  CsgNode node;
  node.number = static_cast<std::int64_t>(scene_.tree.nodes.size());
  node.name = "c" + std::to_string(node.number);
  node.composite = true;
  node.operation = operation;
  node.left = left;
  node.right = right;
  scene_.tree.nodes.push_back(node);
  return scene_.tree.nodes.size() - 1;
}

std::size_t Maker::add_cutting_cube() {
  CsgNode node;
  node.number = static_cast<std::int64_t>(scene_.tree.nodes.size());
  node.name = "cut";
  node.surfaces.fill(kSurfaces + 1);
  node.placement.linear = glm::dmat3(kHigh);
  scene_.tree.nodes.push_back(node);
  return scene_.tree.nodes.size() - 1;
}

Part Maker::add_part(int primitives, bool intersection) {
  const glm::dvec3 centre = any_point(1);
  const double radius = size_ * any(0.8, 1.2);
  Part part{add_primitive(centre, radius), centre, 1.01 * radius};
  for (int i = 1; i < primitives; ++i) {
    const glm::dvec3 beside = centre + any_direction() * (intersection ? 0.5 : 0.8) * radius;
    const std::size_t other = add_primitive(beside, (intersection ? 1.0 : 0.7) * radius);
    part.node = add_composite(intersection ? Operation::intersection : Operation::difference,
                              part.node, other);
  }
  if (wanted_.cut != MadeScene::Cut::distributed) return part;
  bool near = true;
  for (int axis = 0; axis < 3; ++axis)
    near = near && centre[axis] + part.reach > 0 && centre[axis] - part.reach < kHigh;
  if (near) part.node = add_composite(Operation::difference, part.node, add_cutting_cube());
  return part;
}

void Maker::add_parts() {
  const int alone = wanted_.spheres ? wanted_.primitives : wanted_.primitives * 35 / 100;
  for (int i = 0; i < alone; ++i) parts_.push_back(add_part(1, false));
  int left = wanted_.primitives - alone;
  for (int i = 0; left > 0; ++i) {
    const int primitives = std::min(left, i % 3 == 1 ? 3 : 2);
    parts_.push_back(add_part(primitives, i % 3 == 2));
    left -= primitives;
  }
}

// Halves at the median of the centres along the longest axis.
std::size_t Maker::join(std::span<Part> parts) {
  if (parts.size() == 1) return parts[0].node;
  glm::dvec3 low = parts[0].centre, high = low;
  for (const Part& part : parts) {
    low = glm::min(low, part.centre);
    high = glm::max(high, part.centre);
  }
  const glm::dvec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  std::sort(parts.begin(), parts.end(),
            [&](const Part& a, const Part& b) { return a.centre[axis] < b.centre[axis]; });
  const std::size_t half = parts.size() / 2;
  const std::size_t left = join(parts.first(half)), right = join(parts.subspan(half));
  return add_composite(Operation::union_of, left, right);
}

void Maker::look() {
  std::mt19937_64 random(7);
  const auto part = [&] {
    return 0.15 + 0.8 * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  for (int i = 0; i <= kSurfaces; ++i) {
    Surface surface;
    surface.number = i + 1;
    surface.name = "matt " + std::to_string(i + 1);
    const double r = part(), g = part();
    surface.first.diffuse = {r, g, part()};
    surface.first.ambient = 0.8 * surface.first.diffuse;
    scene_.surfaces.push_back(surface);
  }
  scene_.lighting.background = {0.1, 0.12, 0.2};
  scene_.lighting.ambient = glm::dvec3(0.25);
  scene_.lighting.lights = {{{1, 7, 6}, glm::dvec3(0.9)}};
  // The screen lies before everything, the eye as far again behind it.
  CameraFile& camera = scene_.camera;
  camera.window = {1.4, 1.4};
  camera.normal = {-0.5, -0.35, -1};
  camera.distance = camera.focal = 4;
}

Scene Maker::make() {
  add_parts();
  std::size_t root = 0;
  if (wanted_.chain) {
    root = parts_[0].node;
    for (std::size_t i = 1; i < parts_.size(); ++i)
      root = add_composite(Operation::union_of, root, parts_[i].node);
  } else {
    root = join(parts_);
  }
  if (wanted_.cut == MadeScene::Cut::root)
    root = add_composite(Operation::difference, root, add_cutting_cube());
  scene_.tree.root = root;
  look();
  return std::move(scene_);
}

}  // namespace

std::string MadeScene::name() const {
  const char* kind = spheres                   ? "spheres"
                     : cut == Cut::root        ? "cut"
                     : cut == Cut::distributed ? "distributed"
                     : chain                   ? "chain"
                                               : "mixed";
  return kind + ("-" + std::to_string(primitives));
}

Scene made_scene(const MadeScene& wanted) { return Maker(wanted).make(); }

std::vector<MadeScene> made_suite(std::span<const int> sizes) {
  std::vector<MadeScene> suite;
  for (const int primitives : sizes) {
    suite.push_back({.primitives = primitives});
    suite.push_back({.primitives = primitives, .chain = true});
    suite.push_back({.primitives = primitives, .cut = MadeScene::Cut::root});
    suite.push_back({.primitives = primitives, .cut = MadeScene::Cut::distributed});
    suite.push_back({.primitives = primitives, .spheres = true});
  }
  return suite;
}

}  // namespace sir::bench
