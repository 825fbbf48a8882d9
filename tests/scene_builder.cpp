#include "tests/scene_builder.h"

#include <algorithm>
#include <cmath>

namespace sir::test {

SceneBuilder::Id SceneBuilder::primitive(PrimitiveKind kind, const Placement& placement,
                                         std::int64_t surface_number, std::int64_t number) {
  CsgNode node;
  node.number = number >= 0 ? number : static_cast<std::int64_t>(scene.tree.nodes.size());
  node.name = "p" + std::to_string(node.number);
  node.kind = kind;
  node.placement = placement;
  node.surfaces.fill(surface_number);
  surface(surface_number);
  scene.tree.nodes.push_back(node);
  return scene.tree.nodes.size() - 1;
}

SceneBuilder::Id SceneBuilder::cube(glm::dvec3 low, glm::dvec3 high, std::int64_t surface_number,
                                    std::int64_t number) {
  return primitive(PrimitiveKind::cube, placed(high - low, low), surface_number, number);
}

SceneBuilder::Id SceneBuilder::sphere(glm::dvec3 centre, double radius, std::int64_t surface_number,
                                      std::int64_t number) {
  return primitive(PrimitiveKind::sphere, placed(glm::dvec3(radius), centre), surface_number,
                   number);
}

SceneBuilder::Id SceneBuilder::crowd(std::mt19937_64& random, int parts, bool aligned) {
  std::uniform_real_distribution<double> any(-2, 2);
  const auto one = [&] {
    const auto kind = static_cast<PrimitiveKind>(random() % 4);
    if (!aligned) {
      Placement placement = random_placement(random, 0.6, random() % 2);
      placement.translation = {any(random), any(random), any(random)};
      return primitive(kind, placement);
    }
    const auto grid = [&] { return std::round(any(random) * 2) / 2; };
    return primitive(kind, placed(glm::dvec3(0.5), {grid(), grid(), grid()}));
  };
  auto root = one();
  for (int n = 1; n < parts; ++n) {
    auto part = one();
    for (std::uint64_t k = random() % 3; k > 0; --k)
      part = combine(random() % 2 ? Operation::difference : Operation::intersection, part, one());
    root = combine(Operation::union_of, root, part);
  }
  return root;
}

SceneBuilder::Id SceneBuilder::combine(Operation operation, Id left, Id right) {
  CsgNode node;
  node.number = static_cast<std::int64_t>(scene.tree.nodes.size()) + 1000;
  node.name = "c" + std::to_string(node.number);
  node.composite = true;
  node.operation = operation;
  node.left = left;
  node.right = right;
  scene.tree.nodes.push_back(node);
  return scene.tree.nodes.size() - 1;
}

Surface& SceneBuilder::surface(std::int64_t number) {
  for (Surface& known : scene.surfaces)
    if (known.number == number) return known;
  Surface made;
  made.number = number;
  made.name = "s" + std::to_string(number);
  made.first.ambient = made.first.diffuse = glm::dvec3(1);
  scene.surfaces.push_back(made);
  return scene.surfaces.back();
}

Scene SceneBuilder::finish(Id root) {
  scene.tree.root = root;
  return scene;
}

Placement placed(glm::dvec3 scale, glm::dvec3 translation) {
  Placement placement;
  for (int i = 0; i < 3; ++i) placement.linear[i][i] = scale[i];
  placement.translation = translation;
  return placement;
}

Placement random_placement(std::mt19937_64& random, double size, bool shear) {
  std::uniform_real_distribution<double> any(-1, 1);
  // Gram-Schmidt on random columns gives a rotation.
  glm::dvec3 a(any(random), any(random), any(random)), b(any(random), any(random), any(random));
  a = glm::normalize(a);
  b = glm::normalize(b - glm::dot(a, b) * a);
  Placement placement;
  placement.linear = glm::dmat3(a, b, glm::cross(a, b));
  for (int i = 0; i < 3; ++i) placement.linear[i] *= size * (0.6 + 0.4 * any(random));
  if (shear) {
    placement.linear[0] += 0.5 * any(random) * placement.linear[1];
    if (any(random) > 0) placement.linear[2] = -placement.linear[2];
  }
  placement.translation = {any(random), any(random), any(random)};
  return placement;
}

Scene random_scene(std::uint64_t seed, int leaves, bool aligned) {
  std::mt19937_64 random(seed);
  const auto pick = [&](int below) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(below));
  };
  SceneBuilder build;
  constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere,
                                      PrimitiveKind::cone, PrimitiveKind::cylinder};
  std::vector<SceneBuilder::Id> open;
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < leaves; ++i) numbers.push_back(i);
  std::shuffle(numbers.begin(), numbers.end(), random);
  for (int i = 0; i < leaves; ++i) {
    // Cubes more often where faces shall coincide.
    const auto kind = aligned && pick(2) ? PrimitiveKind::cube : kKinds[pick(4)];
    Placement placement;
    if (aligned) {
      placement = placed(glm::dvec3(1 + pick(2), 1 + pick(2), 1 + pick(2)) * 0.5,
                         glm::dvec3(pick(4), pick(4), pick(4)) * 0.5 - 1.0);
    } else {
      placement = random_placement(random, 1, pick(2) == 0);
    }
    open.push_back(
        build.primitive(kind, placement, 1 + pick(3), numbers[static_cast<std::size_t>(i)]));
  }
  // Mostly unions, or little would be left to see.
  constexpr Operation kOperations[] = {
      Operation::union_of,   Operation::union_of,   Operation::union_of,    Operation::union_of,
      Operation::difference, Operation::difference, Operation::intersection};
  while (open.size() > 1) {
    const auto take = [&] {
      const auto at = static_cast<std::size_t>(pick(static_cast<int>(open.size())));
      const auto id = open[at];
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(at));
      return id;
    };
    const auto left = take(), right = take();
    open.push_back(build.combine(kOperations[pick(7)], left, right));
  }
  for (Surface& surface : build.scene.surfaces) {
    surface.first.specular = 0.2 * pick(3);
    surface.first.exponent = 10;
    surface.first.transmission = 0.3 * pick(2);
    surface.first.index = 1.2;
    surface.first.ambient = surface.first.diffuse =
        glm::dvec3(0.2 * (1 + pick(3)), 0.2 * (1 + pick(3)), 0.2 * (1 + pick(3)));
    if (pick(2)) {
      surface.texture = TextureKind::chequer;
      surface.cells_u = surface.cells_v = 3;
      surface.second = surface.first;
      surface.second.diffuse = glm::dvec3(0.1, 0.5, 0.9);
      surface.second.transmission = 0;
    }
  }
  Scene& scene = build.scene;
  scene.camera.window = {1.6, 1.2};
  scene.camera.target = {0, 0, 0};
  scene.camera.normal = {-0.3, -0.4, -1};
  scene.camera.distance = scene.camera.focal = 5;
  scene.camera.up = {0, 1, 0};
  scene.lighting.background = {0.1, 0.2, 0.4};
  scene.lighting.ambient = glm::dvec3(0.2);
  scene.lighting.lights = {{{3, 5, 4}, glm::dvec3(0.7)}, {{-4, 2, 3}, {0.3, 0.2, 0.1}}};
  return build.finish(open[0]);
}

Scene moved(Scene scene, double factor, glm::dvec3 offset) {
  for (CsgNode& node : scene.tree.nodes) {
    node.placement.linear *= factor;
    node.placement.translation = factor * node.placement.translation + offset;
  }
  for (Light& light : scene.lighting.lights) light.position = factor * light.position + offset;
  scene.camera.window *= factor;
  scene.camera.target = factor * scene.camera.target + offset;
  scene.camera.distance *= factor;
  scene.camera.focal *= factor;
  return scene;
}

}  // namespace sir::test
