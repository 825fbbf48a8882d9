#include "tests/property_scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sir::test {
namespace {

glm::dvec3 as_floats(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

Placement grid_placement(Random& random) {
  Placement placement =
      placed(glm::dvec3(1 + random.below(2), 1 + random.below(2), 1 + random.below(2)) * 0.5,
             glm::dvec3(random.below(4), random.below(4), random.below(4)) * 0.5 - 1.0);
  if (random.once_in(3)) {  // another way to place what lies on the same grid
    std::swap(placement.linear[0], placement.linear[random.below(3)]);
    placement.linear[random.below(3)] *= -1.0;
  }
  return placement;
}

Placement random_placement_in(Random& random, Regime regime) {
  if (regime == Regime::aligned) return grid_placement(random);
  Placement placement = random_placement(random.engine(), 1, regime == Regime::sheared);
  if (regime == Regime::sizes) {
    const double size = std::pow(10.0, random.between(-6, 6));
    placement.linear *= size;
    // A large one is moved so that its surface passes near the origin.
    if (size > 1) placement.translation += size * random.direction();
  } else if (regime == Regime::thin) {
    placement.linear[random.below(3)] *= std::pow(10.0, random.between(-9, 0));
  } else if (regime == Regime::sheared) {
    const int from = random.below(3);
    placement.linear[from] +=
        std::pow(10.0, random.between(0, 4)) * placement.linear[(from + 1) % 3];
  }
  return placement;
}

glm::dvec3 grid_direction(Random& random) {
  const glm::dvec3 d = glm::round(random.in_cube(2));
  return d == glm::dvec3(0) ? glm::dvec3(0, 1, 0) : d;
}

}  // namespace

const char* name_of(Regime regime) {
  constexpr const char* kNames[] = {"generic", "aligned", "sizes", "thin", "sheared"};
  return kNames[static_cast<std::size_t>(regime)];
}

glm::dvec3 Random::direction() {
  for (;;) {
    const glm::dvec3 v = in_cube(1);
    const double size = glm::length(v);
    if (size > 0.1 && size < 1) return v / size;
  }
}

SceneBuilder::Id add_random_solid(SceneBuilder& build, Random& random, Regime regime, int leaves) {
  constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere,
                                      PrimitiveKind::cone, PrimitiveKind::cylinder};
  // Mostly unions, or little would be left to see.
  constexpr Operation kOperations[] = {Operation::union_of,   Operation::union_of,
                                       Operation::union_of,   Operation::difference,
                                       Operation::difference, Operation::intersection};
  std::vector<SceneBuilder::Id> open;
  for (int i = 0; i < leaves; ++i) {
    const bool cube = regime == Regime::aligned && random.once_in(2);
    const auto kind = cube ? PrimitiveKind::cube : kKinds[random.below(4)];
    // Distinct while there are fewer than 10007 nodes, a prime.
    const auto number = static_cast<std::int64_t>(build.scene.tree.nodes.size()) * 7919 % 10007;
    const Placement placement = random_placement_in(random, regime);
    open.push_back(build.primitive(kind, placement, 1 + random.below(3), number));
  }
  while (open.size() > 1) {
    const auto take = [&] {
      const auto at = static_cast<std::ptrdiff_t>(random.below(static_cast<int>(open.size())));
      const auto id = open[static_cast<std::size_t>(at)];
      open.erase(open.begin() + at);
      return id;
    };
    const auto left = take(), right = take();
    open.push_back(build.combine(kOperations[random.below(6)], left, right));
  }
  return open.front();
}

SceneBuilder::Id add_copy(SceneBuilder& build, SceneBuilder::Id id) {
  const CsgNode node = build.scene.tree.nodes[id];
  if (node.composite)
    return build.combine(node.operation, add_copy(build, node.left), add_copy(build, node.right));
  return build.primitive(node.kind, node.placement, node.surfaces[0], node.number);
}

void light_and_aim(Scene& scene, Random& random) {
  for (Surface& surface : scene.surfaces) {
    Coefficients& k = surface.first;
    const auto shade = [&] { return 0.25 * random.below(5); };
    k.ambient = {shade(), shade(), shade()};
    k.diffuse = {shade(), shade(), shade()};
    k.specular = random.once_in(2) ? 0.0 : shade();
    k.transmission = random.once_in(2) ? 0.0 : shade();
    constexpr double kExponents[] = {0, 1, 10, 1000, 1e6};
    constexpr double kIndices[] = {1, 1.1, 1.5, 4, 1e-3, 1e3};
    k.exponent = kExponents[random.below(5)];
    k.index = kIndices[random.below(6)];
    if (random.once_in(3)) {
      surface.texture = TextureKind::chequer;
      surface.cells_u = 1 + random.below(9);
      surface.cells_v = 1 + random.below(9);
      surface.second = k;
      surface.second.transmission = 0;
      surface.second.diffuse = {0.1, 0.5, 0.9};
    }
  }
  scene.camera.window = {1.6, 1.2};
  scene.camera.target = {0, 0, 0};
  scene.camera.normal = -random.direction();
  scene.camera.up = random.direction();
  scene.camera.distance = scene.camera.focal = random.between(2, 6);
  scene.lighting.background = {0.125, 0.25, 0.5};
  scene.lighting.ambient = glm::dvec3(0.25);
  scene.lighting.lights = {{4.0 * random.direction(), glm::dvec3(0.75)},
                           {random.in_cube(1), {0.5, 0.25, 0.125}}};
}

std::string describe(const TestRay& ray) {
  std::ostringstream text;
  text.precision(17);
  for (const glm::dvec3& v : {ray.origin, ray.direction})
    text << v.x << ' ' << v.y << ' ' << v.z << ' ';
  return text.str();
}

TestRay random_ray(const Scene& scene, Random& random, Regime regime) {
  if (regime == Regime::aligned && !random.once_in(3)) {
    const glm::dvec3 grid = glm::round(random.in_cube(6)) / 4.0;
    return {grid + glm::dvec3(random.once_in(2) ? 0.125 : 0.0), grid_direction(random)};
  }
  const CsgNode* leaf = nullptr;
  while (leaf == nullptr || leaf->composite)
    leaf = &scene.tree.nodes[static_cast<std::size_t>(
        random.below(static_cast<int>(scene.tree.nodes.size())))];
  const glm::dvec3 target =
      leaf->placement.translation + leaf->placement.linear * random.in_cube(1.1);
  const glm::dvec3 away = random.direction();
  glm::dvec3 origin = target + std::pow(10.0, random.between(-3, 3)) * away;
  if (random.once_in(3)) origin = random.in_cube(2);
  if (random.once_in(8)) origin = target;  // as likely inside as not
  origin = as_floats(origin);
  glm::dvec3 direction = as_floats(target - origin);
  if (direction == glm::dvec3(0)) direction = as_floats(away);
  return {origin, direction};
}

}  // namespace sir::test
