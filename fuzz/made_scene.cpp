#include "fuzz/made_scene.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace sir::fuzz {
namespace {

constexpr int kMostLeaves = 12, kMostSurfaces = 4, kMostLights = 3;

glm::dvec3 point(ByteSource& source) {
  const double x = source.coordinate(), y = source.coordinate();
  return {x, y, source.coordinate()};
}

glm::dvec3 colour(ByteSource& source) {
  const double r = source.share(), g = source.share();
  return {r, g, source.share()};
}

// Scaled along the axes; perhaps turned about one of them; perhaps sheared at will.
Placement placement(ByteSource& source) {
  Placement placed;
  const int kind = source.below(4);
  if (kind == 3) {
    for (int line = 0; line < 3; ++line) placed.linear[line] = point(source);
  } else {
    for (int axis = 0; axis < 3; ++axis)
      placed.linear[axis][axis] = kind == 0 && axis > 0 ? placed.linear[0][0] : source.extent();
    if (kind == 2) {
      const int x = source.below(3), y = (x + 1) % 3;
      const double angle = source.byte() * std::numbers::pi / 24;
      for (int line = 0; line < 3; ++line) {
        const double a = placed.linear[line][x], b = placed.linear[line][y];
        placed.linear[line][x] = std::cos(angle) * a - std::sin(angle) * b;
        placed.linear[line][y] = std::sin(angle) * a + std::cos(angle) * b;
      }
    }
  }
  placed.translation = point(source);
  return placed;
}

Coefficients coefficients(ByteSource& source) {
  Coefficients k;
  k.ambient = colour(source);
  k.diffuse = colour(source);
  k.specular = source.share();
  k.exponent = source.below(64);
  k.transmission = source.share();
  k.index = source.flag() ? 1 : 0.5 + source.below(32) / 16.0;
  return k;
}

void make_surfaces(ByteSource& source, Scene& scene) {
  const int count = 1 + source.below(kMostSurfaces);
  for (int i = 0; i < count; ++i) {
    Surface surface;
    surface.number = i;
    surface.name = "s";
    surface.first = coefficients(source);
    if (source.below(4) == 0) {
      surface.texture = TextureKind::chequer;
      surface.second = coefficients(source);
      surface.cells_u = std::int64_t{1} << source.below(63);
      surface.cells_v = 1 + source.below(8);
    }
    scene.surfaces.push_back(surface);
  }
}

CsgNode primitive(ByteSource& source, int surfaces) {
  CsgNode node;
  node.kind = static_cast<PrimitiveKind>(source.below(4));
  node.surface_per_face = face_count(node.kind) > 1 && source.below(4) == 0;
  node.surfaces.fill(source.below(surfaces));
  for (int face = 1; node.surface_per_face && face < face_count(node.kind); ++face)
    node.surfaces[static_cast<std::size_t>(face)] = source.below(surfaces);
  node.placement = placement(source);
  return node;
}

// Two of the solids so far become one, as often as there are two.
void make_tree(ByteSource& source, Scene& scene) {
  CsgTree& tree = scene.tree;
  std::vector<std::size_t> solids;
  const auto add = [&](CsgNode node) {
    node.number = static_cast<std::int64_t>(tree.nodes.size());
    node.name = "n";
    solids.push_back(tree.nodes.size());
    tree.nodes.push_back(node);
  };
  const auto take = [&] {
    const auto at = solids.begin() + source.below(static_cast<int>(solids.size()));
    const std::size_t taken = *at;
    solids.erase(at);
    return taken;
  };
  const int leaves = 1 + source.below(kMostLeaves);
  for (int i = 0; i < leaves; ++i) add(primitive(source, static_cast<int>(scene.surfaces.size())));
  while (solids.size() > 1) {
    CsgNode node;
    node.composite = true;
    node.operation = static_cast<Operation>(source.below(3));
    node.left = take();
    node.right = take();
    add(node);
  }
  tree.root = tree.nodes.size() - 1;
}

void aim(ByteSource& source, CameraFile& camera) {
  camera.window = {0.25 * (1 + source.below(32)), 0.25 * (1 + source.below(32))};
  camera.target = point(source);
  camera.normal = point(source);
  if (camera.normal == glm::dvec3(0)) camera.normal.z = -1;
  camera.distance = std::abs(source.extent());
  camera.up = source.flag() ? point(source) : glm::dvec3(0, 1, 0.25);
  camera.parallel = source.below(4) == 0;
  camera.focal_given = !camera.parallel && source.flag();
  camera.focal = camera.focal_given ? std::abs(source.extent()) : camera.distance;
}

void light(ByteSource& source, Lighting& lighting) {
  lighting.background = colour(source);
  lighting.ambient = colour(source);
  const int count = source.below(kMostLights + 1);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 position = point(source);
    lighting.lights.push_back({position, colour(source)});
  }
}

}  // namespace

Scene made_scene(ByteSource& source) {
  Scene scene;
  aim(source, scene.camera);
  light(source, scene.lighting);
  make_surfaces(source, scene);
  make_tree(source, scene);
  return scene;
}

}  // namespace sir::fuzz
