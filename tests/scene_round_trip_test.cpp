#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/scene_file.h"

// What the writers of scene_file.h write, its readers read back to the last bit.

namespace sir {
namespace {

// Any finite double, with all its bits.
double any_double(std::mt19937_64& random) {
  while (true) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

double any_non_negative(std::mt19937_64& random) { return std::abs(any_double(random)); }

glm::dvec3 three(std::mt19937_64& random, double (*draw)(std::mt19937_64&)) {
  const double x = draw(random), y = draw(random), z = draw(random);
  return {x, y, z};
}

// Bits, not values: -0 is not 0.
bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
  for (int i = 0; i < 3; ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

TEST(RoundTrip, CsgKeepsEveryBit) {
  const char* const names[] = {"a", "dois nomes", "Pirâmide nº 3", "3", "CUBO", "\"x\""};
  for (std::uint64_t seed = 0; seed < test::cases(40); ++seed) {
    std::mt19937_64 random(seed);
    CsgTree tree = test::random_scene(seed, 1 + static_cast<int>(seed % 12), false).tree;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      CsgNode& node = tree.nodes[i];
      node.number = static_cast<std::int64_t>((random() >> 1) / 100 * 100 + i);
      node.name = names[random() % std::size(names)];
      if (node.composite) continue;
      node.surface_per_face = face_count(node.kind) > 1 && random() % 2 == 0;
      node.surfaces = {};
      for (int face = 0; face < face_count(node.kind); ++face)
        node.surfaces[static_cast<std::size_t>(face)] =
            node.surface_per_face || face == 0 ? static_cast<std::int64_t>(random() >> 1)
                                               : node.surfaces[0];
      node.placement.translation = three(random, any_double);
    }
    TextFile file("B.CSG", csg_text(tree));
    const CsgTree again = read_csg(file);
    ASSERT_EQ(again.nodes.size(), tree.nodes.size());
    EXPECT_EQ(again.root, tree.root);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const CsgNode &a = tree.nodes[i], &b = again.nodes[i];
      EXPECT_EQ(a.number, b.number);
      EXPECT_EQ(a.name, b.name);
      ASSERT_EQ(a.composite, b.composite);
      if (a.composite) {
        EXPECT_EQ(a.operation, b.operation);
        EXPECT_EQ(a.left, b.left);
        EXPECT_EQ(a.right, b.right);
        continue;
      }
      EXPECT_EQ(a.kind, b.kind);
      EXPECT_EQ(a.surfaces, b.surfaces);
      EXPECT_EQ(a.surface_per_face, b.surface_per_face);
      for (int line = 0; line < 3; ++line)
        EXPECT_TRUE(same_bits(a.placement.linear[line], b.placement.linear[line]));
      EXPECT_TRUE(same_bits(a.placement.translation, b.placement.translation));
    }
    EXPECT_EQ(csg_text(again), csg_text(tree));
  }
}

TEST(RoundTrip, CameraKeepsEveryBit) {
  for (std::uint64_t seed = 0; seed < test::cases(60); ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> direction(-1, 1);
    CameraFile camera;
    camera.window = {any_non_negative(random), any_non_negative(random)};
    camera.target = three(random, any_double);
    // Of any size, but not parallel.
    camera.normal = glm::dvec3(direction(random), direction(random), direction(random)) * 1e-200;
    camera.up = glm::dvec3(direction(random), direction(random), direction(random)) * 1e200;
    camera.distance = any_non_negative(random);
    camera.parallel = seed % 3 == 0;
    camera.focal_given = seed % 3 == 1;
    camera.focal = camera.focal_given ? any_non_negative(random) : camera.distance;
    TextFile file("B.CAM", camera_text(camera));
    const CameraFile again = read_camera(file);
    EXPECT_EQ(camera.window, again.window);
    EXPECT_TRUE(same_bits(camera.target, again.target));
    EXPECT_TRUE(same_bits(camera.normal, again.normal));
    EXPECT_TRUE(same_bits(camera.up, again.up));
    EXPECT_EQ(camera.distance, again.distance);
    EXPECT_EQ(camera.focal, again.focal);
    EXPECT_EQ(camera.parallel, again.parallel);
    EXPECT_EQ(camera.focal_given, again.focal_given);
  }
}

TEST(RoundTrip, LightingKeepsEveryBit) {
  for (std::uint64_t seed = 0; seed < test::cases(30); ++seed) {
    std::mt19937_64 random(seed);
    Lighting lighting;
    lighting.background = three(random, any_non_negative);
    lighting.ambient = three(random, any_non_negative);
    lighting.lights.resize(seed % 4);
    for (Light& light : lighting.lights)
      light = {three(random, any_double), three(random, any_non_negative)};
    TextFile file("B.LUZ", lighting_text(lighting));
    const Lighting again = read_lighting(file);
    EXPECT_TRUE(same_bits(lighting.background, again.background));
    EXPECT_TRUE(same_bits(lighting.ambient, again.ambient));
    ASSERT_EQ(lighting.lights.size(), again.lights.size());
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
      EXPECT_TRUE(same_bits(lighting.lights[i].position, again.lights[i].position));
      EXPECT_TRUE(same_bits(lighting.lights[i].intensity, again.lights[i].intensity));
    }
  }
}

TEST(RoundTrip, SurfacesKeepEveryBit) {
  const auto draw = [](std::mt19937_64& random) {
    Coefficients k;
    k.ambient = three(random, any_non_negative);
    k.diffuse = three(random, any_non_negative);
    k.specular = any_non_negative(random);
    k.exponent = any_non_negative(random);
    k.transmission = random() % 2 == 0 ? 0 : any_non_negative(random);
    k.index = any_non_negative(random);
    return k;
  };
  const auto same = [](const Coefficients& a, const Coefficients& b) {
    return same_bits(a.ambient, b.ambient) && same_bits(a.diffuse, b.diffuse) &&
           same_bits({a.specular, a.exponent, a.transmission},
                     {b.specular, b.exponent, b.transmission}) &&
           a.index == b.index;
  };
  for (std::uint64_t seed = 0; seed < test::cases(30); ++seed) {
    std::mt19937_64 random(seed);
    std::vector<Surface> surfaces(seed % 5);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      surfaces[i] = {static_cast<std::int64_t>((random() >> 1) / 8 * 8 + i),
                     "maçã verde",
                     TextureKind::plain,
                     draw(random),
                     {},
                     1,
                     1};
      if (random() % 2 == 0) continue;
      surfaces[i].texture = TextureKind::chequer;
      surfaces[i].second = draw(random);
      surfaces[i].cells_u = static_cast<std::int64_t>((random() >> 1) | 1);
      surfaces[i].cells_v = static_cast<std::int64_t>((random() >> 1) | 1);
    }
    TextFile file("B.SUP", surfaces_text(surfaces));
    const auto again = read_surfaces(file);
    ASSERT_EQ(again.size(), surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const Surface &a = surfaces[i], &b = again[i];
      EXPECT_EQ(a.number, b.number);
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.texture, b.texture);
      EXPECT_TRUE(same(a.first, b.first) && same(a.second, b.second));
      EXPECT_EQ(a.cells_u, b.cells_u);
      EXPECT_EQ(a.cells_v, b.cells_v);
    }
  }
}

}  // namespace
}  // namespace sir
