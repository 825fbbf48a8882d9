#include "tests/pov_scenes.h"

#include <array>
#include <cmath>
#include <random>

#include "tests/scene_builder.h"
#include "tracer/colour.h"
#include "tracer/render.h"

namespace sir::test {
namespace {

using Id = SceneBuilder::Id;

constexpr std::int64_t kFloor = 90;

// A coloured surface; its ambient coefficients follow neither Kd nor white.
Surface& coloured(SceneBuilder& build, std::int64_t number, glm::dvec3 kd, double ks, double n) {
  Surface& surface = build.surface(number);
  surface.first = {{0.3 * kd.b, 0.3, 0.2 + 0.1 * kd.r}, kd, ks, n, 0, 0};
  return surface;
}

Surface& glass(SceneBuilder& build, std::int64_t number, double kt, double index) {
  Surface& surface = coloured(build, number, {0.1, 0.05, 0.15}, 1 - kt, 60);
  surface.first.transmission = kt;
  surface.first.index = index;
  return surface;
}

Surface& chequered(SceneBuilder& build, std::int64_t number, std::int64_t nu, std::int64_t nv) {
  Surface& surface = coloured(build, number, {0.8, 0.7, 0.2}, 0, 1);
  surface.texture = TextureKind::chequer;
  surface.cells_u = nu;
  surface.cells_v = nv;
  surface.second = surface.first;
  surface.second.diffuse = {0.1, 0.3, 0.7};
  return surface;
}

// A chequered slab below y = -1.2, so that there is something to mirror, to
// refract and to throw shadows on.
Id floor_slab(SceneBuilder& build) {
  chequered(build, kFloor, 11, 13);
  return build.cube({-5.03, -1.5, -6.07}, {5.01, -1.21, 3.05}, kFloor);
}

// All of `parts` as one solid.
Scene united(SceneBuilder& build, const std::vector<Id>& parts) {
  Id whole = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    whole = build.combine(Operation::union_of, whole, parts[i]);
  Scene& scene = build.scene;
  scene.camera.window = {1.6, 1.2};
  scene.camera.target = {0, 0, 0};
  scene.camera.normal = {-0.31, -0.42, -1};
  scene.camera.distance = 5;
  scene.camera.focal = 4;
  scene.camera.up = {0.05, 1, 0};
  scene.lighting.background = {0.1, 0.2, 0.4};
  scene.lighting.ambient = {0.5, 0.4, 0.3};
  scene.lighting.lights = {{{3, 5, 4}, {0.7, 0.65, 0.6}}, {{-4, 2.5, 3}, {0.3, 0.25, 0.1}}};
  return build.finish(whole);
}

// One of each kind of primitive in a row, turned and sheared.
std::vector<Id> four_kinds(SceneBuilder& build, std::int64_t surface, bool shear) {
  constexpr std::array kKinds{PrimitiveKind::cube, PrimitiveKind::sphere, PrimitiveKind::cone,
                              PrimitiveKind::cylinder};
  std::mt19937_64 random(5);
  std::vector<Id> made;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    Placement placement = random_placement(random, 0.5, shear);
    placement.translation = {0.95 * static_cast<double>(i) - 1.3, 0.3 * (i % 2 == 0 ? 1 : -1), 0};
    made.push_back(build.primitive(kKinds[i], placement, surface));
  }
  return made;
}

Scene kinds_with(void (*describe)(SceneBuilder&), bool shear) {
  SceneBuilder build;
  std::vector<Id> parts = four_kinds(build, 1, shear);
  describe(build);
  parts.push_back(floor_slab(build));
  return united(build, parts);
}

Scene per_face() {
  SceneBuilder build;
  std::vector<Id> parts = four_kinds(build, 1, true);
  for (std::int64_t s = 1; s <= 6; ++s) {
    const double x = 0.15 * static_cast<double>(s);
    coloured(build, s, {x, 1 - x, 0.5}, s % 2 == 0 ? 0.3 : 0, 20);
  }
  chequered(build, 3, 3, 5);
  for (CsgNode& node : build.scene.tree.nodes)
    for (std::size_t face = 0; face < 6; ++face)
      node.surfaces[face] = 1 + static_cast<std::int64_t>(face);
  parts.push_back(floor_slab(build));
  return united(build, parts);
}

Scene mirrors() {
  SceneBuilder build;
  coloured(build, 1, {0.1, 0.2, 0.1}, 0.7, 50);
  coloured(build, 2, {0.6, 0.1, 0.1}, 0.4, 0);  // N.H to the power 0
  return united(build,
                {build.sphere({-0.9, -0.2, 0}, 0.8, 1), build.sphere({0.9, -0.3, 0.2}, 0.8, 1),
                 build.cube({-2, -1.1, -2.5}, {2, 1.5, -2.2}, 2), floor_slab(build)});
}

// Members of the union overlap, and one glass solid has a bore.
Scene glass_difference(double kt, double index) {
  SceneBuilder build;
  glass(build, 1, kt, index);
  glass(build, 2, kt / 2, index).second = {};
  const Id bored =
      build.combine(Operation::difference, build.cube({-1.6, -1, -0.8}, {-0.1, 0.7, 0.8}),
                    build.sphere({-0.5, 0.4, 0.6}, 0.7, 2));
  const Id lens = build.combine(Operation::intersection, build.sphere({0.8, 0, -0.3}, 0.9),
                                build.sphere({0.9, 0.2, 0.5}, 0.9));
  return united(build, {bored, lens, build.sphere({1.4, -0.3, 0.1}, 0.5, 2), floor_slab(build)});
}

// A member of glass for each index, apart from one another.
Scene two_glasses() {
  SceneBuilder build;
  glass(build, 1, 0.8, 1.5);
  glass(build, 2, 0.6, 1.1);
  coloured(build, 3, {0.7, 0.2, 0.2}, 0, 1);
  return united(build, {build.sphere({-0.9, -0.2, 0}, 0.7, 1), build.sphere({0.9, -0.2, 0}, 0.7, 2),
                        build.sphere({-1.2, 0.3, 0.1}, 0.5, 1),
                        build.sphere({0.1, 0, -1.5}, 0.6, 3), floor_slab(build)});
}

// Shadows through two sheets and through chequers half of which are opaque.
Scene coloured_shadows() {
  SceneBuilder build;
  glass(build, 1, 1, 1);
  glass(build, 2, 0.45, 1).first.specular = 0;
  Surface& lattice = chequered(build, 3, 4, 6);
  lattice.first.transmission = 0.7;
  lattice.first.index = 1;
  return united(build, {build.cube({-2, 1.0, -2}, {0.2, 1.05, 1}, 1),
                        build.cube({-1.3, 0.5, -1.5}, {1.4, 0.52, 0.7}, 2),
                        build.cube({-1, -0.1, -1}, {2, 0.0, 1.5}, 3), floor_slab(build)});
}

Scene parallel() {
  Scene scene = per_face();
  scene.camera.parallel = true;
  scene.camera.window = {6, 4};  // not the image's shape
  return scene;
}

// A wall stands between the eye and the screen; it is seen in the mirror alone.
Scene before_the_screen() {
  SceneBuilder build;
  coloured(build, 1, {0.2, 0.1, 0.1}, 0.8, 50);
  coloured(build, 2, {0.2, 0.8, 0.1}, 0, 1);
  Scene scene = united(build, {build.sphere({0, 0, 0}, 1.1, 1),
                               build.cube({1, 0.5, 5.2}, {3, 4, 5.9}, 2), floor_slab(build)});
  scene.camera.focal = 6;
  scene.camera.window = {3, 2};
  return scene;
}

// Eye and screen within glass.
Scene within_glass() {
  SceneBuilder build;
  glass(build, 1, 0.8, 1.3);
  coloured(build, 2, {0.9, 0.5, 0.3}, 0.2, 9);
  Scene scene = united(build, {build.cube({-9, -1, 1.5}, {9, 9, 14}, 1),
                               build.sphere({0.4, 0.2, -1}, 1, 2), floor_slab(build)});
  scene.camera.normal = {-0.1, -0.2, -1};
  return scene;
}

// Opaque solids by the hundred, as a left-deep chain.
Scene long_chain() {
  SceneBuilder build;
  std::mt19937_64 random(3);
  std::vector<Id> parts;
  coloured(build, 1, {0.8, 0.3, 0.3}, 0.3, 30);
  coloured(build, 2, {0.3, 0.8, 0.6}, 0, 1);
  for (int i = 0; i < 300; ++i)
    parts.push_back(build.primitive(static_cast<PrimitiveKind>(i % 4),
                                    random_placement(random, 0.12, true), 1 + i % 2));
  for (std::size_t i = 0; i < parts.size(); ++i)
    build.scene.tree.nodes[parts[i]].placement.translation *= 1.2;
  parts.push_back(floor_slab(build));
  return united(build, parts);
}

Scene cut_chain() {
  SceneBuilder build;
  chequered(build, 1, 4, 4);
  coloured(build, 2, {0.8, 0.3, 0.3}, 0.3, 30);
  coloured(build, 3, {0.2, 0.7, 0.3}, 0, 1);
  Id left = build.cube({-1.2, -1, -1.1}, {1.3, 1, 1.2}, 1);
  for (int i = 0; i < 6; ++i)
    left = build.combine(Operation::difference, left,
                         build.sphere({-1.1 + 0.45 * i, 0.8 - 0.3 * i, 1.1}, 0.45, 2 + i % 2));
  const Id both = build.combine(Operation::union_of, build.sphere({1.2, 1, 0}, 0.6, 2),
                                build.sphere({-1.2, 1, 0}, 0.6, 3));
  return united(build, {build.combine(Operation::difference, left, both), floor_slab(build)});
}

// Of a small image's pixels, how many are not background.
double seen_share(const Scene& scene) {
  RenderOptions options;
  options.size = {64, 48};
  const Planes planes = render(scene, options).planes;
  const Rgb8 background = to_rgb8(scene.lighting.background);
  std::size_t seen = 0;
  for (std::size_t p = 0; p < planes.size.pixels(); ++p) seen += planes.at(p) != background;
  return static_cast<double>(seen) / static_cast<double>(planes.size.pixels());
}

// ks = 1 - kt on every transparent surface.
Scene with_shared_out_light(Scene scene) {
  for (Surface& surface : scene.surfaces)
    for (Coefficients* k : {&surface.first, &surface.second})
      if (k->transmission > 0) k->specular = 1 - k->transmission;
  return scene;
}

}  // namespace

std::vector<PovCase> pov_cases() {
  std::vector<PovCase> cases{
      {"matt", kinds_with(
                   [](SceneBuilder& b) {
                     coloured(b, 1, {1.4, 0.5, 0.2}, 0, 1);
                   },
                   false)},
      {"sheared", kinds_with(
                      [](SceneBuilder& b) {
                        coloured(b, 1, {0.9, 0.5, 0}, 0.2, 35);
                      },
                      true)},
      {"chequers", kinds_with([](SceneBuilder& b) { chequered(b, 1, 7, 4); }, true)},
      {"per_face", per_face()},
      {"mirrors", mirrors(), 9},
      {"glass_of_index_1", glass_difference(0.7, 1), 7},
      {"glass_of_index_1_5", glass_difference(0.8, 1.5), 7},
      {"clear_glass", glass_difference(1, 1.5), 4},
      {"glass_kinds", kinds_with([](SceneBuilder& b) { glass(b, 1, 0.75, 1.5); }, true)},
      {"two_glasses", two_glasses()},
      {"coloured_shadows", coloured_shadows(), 12},
      {"parallel", parallel()},
      {"before_the_screen", before_the_screen()},
      {"within_glass", within_glass()},
      {"long_chain", long_chain()},
      {"cut_chain", cut_chain()},
      {"far_away", moved(glass_difference(0.8, 1.5), std::ldexp(1, 30), {7e15, -3e15, 1e15})},
      {"tiny", moved(mirrors(), std::ldexp(1, -30), {})},
  };
  for (PovCase& generated : pov_random_cases()) {
    generated.scene = with_shared_out_light(std::move(generated.scene));
    cases.push_back(std::move(generated));
  }
  return cases;
}

std::vector<PovCase> pov_random_cases() {
  std::vector<PovCase> cases;
  for (std::uint64_t seed = 0; cases.size() < 8; ++seed) {
    Scene scene = random_scene(seed, 12, false);
    scene.camera.window = {2.4, 1.8};
    if (seen_share(scene) > 0.2) cases.push_back({"random_" + std::to_string(seed), scene});
  }
  return cases;
}

}  // namespace sir::test
