// Rays are spared only where no byte can change: the ledger's promise on random
// bookings, and the images with and without it.
#include "tracer/pixel_ledger.h"

#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/radiance_bound.h"
#include "tracer/render.h"
#include "tracer/trace.h"

namespace sir {
namespace {

TEST(PixelLedger, DecidesWhereTheBytesAreSure) {
  PixelLedger<double> ledger;
  ledger.open(true);
  EXPECT_TRUE(ledger.decided());  // nothing comes: black
  ledger.expect(Colour<double>(0.5));
  EXPECT_FALSE(ledger.decided());
  ledger.settle(Colour<double>(0.5), Colour<double>(100.25 / 255));
  EXPECT_TRUE(ledger.decided());
  ledger.expect(Colour<double>(0.2 / 255));  // to 100.45: still 100
  EXPECT_TRUE(ledger.decided());
  ledger.expect(Colour<double>(0, 0.2 / 255, 0));  // one channel to 100.65
  EXPECT_FALSE(ledger.decided());
  ledger.settle(Colour<double>(0), Colour<double>(1));  // all are full
  EXPECT_TRUE(ledger.decided());
  ledger.expect(Colour<double>(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(ledger.decided());
}

template <typename T>
void keep_the_promise(std::uint64_t seed, int& decided) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<T> any(0, 1);
  PixelLedger<T> ledger;
  ledger.open(true);
  Colour<T> sum(0);
  std::vector<Colour<T>> awaited;
  for (int n = 0; n < 40; ++n) {
    // Ever smaller, as along a tree of rays.
    const Colour<T> most =
        Colour<T>(any(random), any(random), any(random)) * std::pow(T(0.7), static_cast<T>(n));
    ledger.expect(most);
    awaited.push_back(most);
    if (random() % 3 == 0) continue;
    const std::size_t which = random() % awaited.size();
    const Colour<T> came = awaited[which] * any(random);
    ledger.settle(awaited[which], came);
    sum += came;
    awaited.erase(awaited.begin() + static_cast<std::ptrdiff_t>(which));
    if (!ledger.decided()) continue;
    ++decided;
    const Rgb8 now = to_rgb8(sum);
    for (int trial = 0; trial < 4; ++trial) {
      Colour<T> later = sum;
      for (const Colour<T>& still : awaited) later += still * (trial ? any(random) : T(1));
      ASSERT_EQ(to_rgb8(later), now) << "seed " << seed;
    }
  }
}

TEST(PixelLedger, WhatItDecidesStands) {
  int decided = 0;
  for (std::uint64_t seed = 0; seed < test::cases(4000); ++seed) {
    ASSERT_NO_FATAL_FAILURE(keep_the_promise<double>(seed, decided));
    ASSERT_NO_FATAL_FAILURE(keep_the_promise<float>(seed, decided));
  }
  EXPECT_GT(decided, 1000);
}

TEST(RadianceBound, NoRayBringsMore) {
  for (std::uint64_t seed = 0; seed < test::cases(60); ++seed) {
    const Scene scene = test::random_scene(seed, 1 + static_cast<int>(seed) % 9, seed % 3 == 0);
    const Model<double> model(scene, {});
    for (const int depth : {1, 2, 5, 70}) {
      TraceOptions options;
      options.depth_limit = depth;
      if (depth > 9) options.cutoff = 0.05;  // a tree of 2^70 rays is too much to ask
      options.past_limit = seed % 2 ? PastLimit::background : PastLimit::zero;
      const Colour<double> most = RadianceBound<double>(model, options).at(1);
      Tracer<double> tracer(model, options);
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 16; ++i) {
          const auto came = tracer.radiance(model.camera.primary_ray(i, j, {16, 12}));
          for (int channel = 0; channel < 3; ++channel)
            ASSERT_LE(came[channel], most[channel]) << "seed " << seed << " depth " << depth;
        }
    }
  }
}

TEST(SparedRays, ChangeNoByte) {
  std::uint64_t spared = 0;
  for (std::uint64_t seed = 0; seed < test::cases(300); ++seed) {
    Scene scene = test::random_scene(seed, 2 + static_cast<int>(seed) % 10, seed % 4 == 0);
    // Dim mirrors and glass, and every third time light enough to fill the bytes.
    for (Surface& surface : scene.surfaces) surface.first.specular *= 0.1 * double(seed % 7);
    for (Light& light : scene.lighting.lights) light.intensity *= seed % 3 == 0 ? 6.0 : 1.0;
    RenderOptions options;
    options.size = {32, 24};
    options.trace.depth_limit = 1 + static_cast<int>(seed % 8);
    options.trace.past_limit = seed % 2 ? PastLimit::background : PastLimit::zero;
    options.precision = seed % 5 == 0 ? Precision::float_ : Precision::double_;
    const auto needed = render(scene, options);
    options.trace.allowed_effects.exhaustive = true;
    const auto all = render(scene, options);
    ASSERT_EQ(needed.planes, all.planes) << seed;
    ASSERT_EQ(all.counts.spared, 0u);
    spared += needed.counts.spared;
  }
  EXPECT_GT(spared, 1000u);  // or nothing was tried
}

// Two slabs in a row, the front one of dim glass, and lights behind the camera.
Scene two_slabs(const Coefficients& front, const Coefficients& back,
                const std::vector<Light>& lights) {
  test::SceneBuilder build;
  const auto near = build.cube({-9, -9, 1}, {9, 9, 2}, 1),
             far = build.cube({-9, -9, -2}, {9, 9, -1}, 2);
  build.surface(1).first = front;
  build.surface(2).first = back;
  build.scene.lighting = {glm::dvec3(0), glm::dvec3(1), lights};
  Scene scene = build.finish(build.combine(Operation::union_of, near, far));
  scene.camera = {{1, 1}, {0, 0, 0}, {0, 0, -1}, 5, {0, 1, 0}, true, 5, false};
  return scene;
}

void expect_auto_equals_all(const Scene& scene, Precision precision, const std::string& what) {
  RenderOptions options;
  options.size = {2, 2};
  options.precision = precision;
  const Planes needed = render(scene, options).planes;
  options.trace.allowed_effects.exhaustive = true;
  EXPECT_EQ(needed, render(scene, options).planes) << what;
}

TEST(SparedRays, WhatOverflowsHasNoBound) {
  Coefficients front, back;
  front.ambient = glm::dvec3(0.1);
  front.transmission = 0.5;
  front.index = 1;
  back.ambient = glm::dvec3(1);
  expect_auto_equals_all(
      two_slabs(front, back, {{{0, 0, 9}, glm::dvec3(1.5e308)}, {{1, 0, 9}, glm::dvec3(1.5e308)}}),
      Precision::double_, "lights whose sum is infinite");
  expect_auto_equals_all(
      two_slabs(front, back, {{{0, 0, 9}, glm::dvec3(2e38)}, {{1, 0, 9}, glm::dvec3(2e38)}}),
      Precision::float_, "the same in float");
  Scene dark = two_slabs(front, back, {{{0, 0, 9}, glm::dvec3(1)}});
  dark.lighting.ambient = glm::dvec3(0);
  dark.surfaces[0].first.diffuse = glm::dvec3(2);
  for (double Coefficients::*member : {&Coefficients::specular, &Coefficients::exponent}) {
    dark.surfaces[1].first.*member = 1e39;
    expect_auto_equals_all(dark, Precision::float_, "coefficients that are infinite in float");
  }
  dark.surfaces[1].first.ambient = glm::dvec3(1e39);
  expect_auto_equals_all(dark, Precision::float_, "no number at all");
}

TEST(SparedRays, ManyLightsRoundManyTimes) {
  // The sum of 20,000 equal floats comes out 0.1 % too large; the mirror shows it
  // times ks, at the edge of a byte.
  Coefficients front, back;
  front.specular = 0.0014;
  back.ambient = back.diffuse = glm::dvec3(1);
  std::vector<Light> lights(20000, {{0, 0, -9}, glm::dvec3(7.2e-8)});
  for (int step = -40; step <= 40; ++step) {
    Scene scene = two_slabs(front, back, lights);
    scene.surfaces[0].first.ambient = glm::dvec3(0.0005551179638132453 + step * 2e-9);
    // The wall that the mirror shows stands behind the camera and faces it.
    scene.tree.nodes[1].placement.translation.z += 30;
    for (Light& light : scene.lighting.lights) light.position = {0, 0, 6};
    expect_auto_equals_all(scene, Precision::float_, std::to_string(step));
  }
}

TEST(SparedRays, LightsAtTinyAndHugeDistancesAreNoBrighter) {
  // |light - point|^2 would underflow, or overflow: the way's length is right all the same.
  for (const double distance : {1e-170, 2.3e-162, 1e-150, 1e-22, 1.0, 1e20, 1e155, 1e160}) {
    const VectorCena<double> way{{distance * 0.6, 0, distance * 0.8}};
    EXPECT_NEAR(length(way) / distance, 1, 1e-15) << distance;
    EXPECT_NEAR(normalize(way).v.z, 0.8, 1e-15) << distance;
  }
  for (const float distance : {1e-30f, 4e-23f, 1e-15f, 1.0f, 1e19f, 1e30f}) {
    const VectorCena<float> way{{distance * 0.6f, 0, distance * 0.8f}};
    EXPECT_NEAR(length(way) / distance, 1, 1e-6) << distance;
    EXPECT_NEAR(normalize(way).v.z, 0.8, 1e-6) << distance;
  }
}

}  // namespace
}  // namespace sir
