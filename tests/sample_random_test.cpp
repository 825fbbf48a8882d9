// Scattered rays: their places, and what they converge to.
#include "tracer/sample_random.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sample_recorder.h"
#include "tests/scene_builder.h"

namespace sir {
namespace {

using test::expect_crop;
using test::Recorder;

RenderOptions scattered(int samples, std::uint64_t seed = 1) {
  RenderOptions options;
  options.size = {60, 44};
  options.antialias.mode = Antialias::random;
  options.antialias.samples = samples;
  options.antialias.seed = seed;
  return options;
}

TEST(SampleRandom, EveryStratumHoldsOnePointAtMost) {
  for (int samples = 1; samples <= 300; ++samples) {
    const int m = static_cast<int>(std::sqrt(samples)), n = (samples + m - 1) / m;
    for (const auto& [i, j] : {std::pair{0, 0}, {5, 3}, {639, 479}}) {
      std::set<int> rows, strips;
      std::set<std::pair<int, int>> cells;
      for (int s = 0; s < samples; ++s) {
        const ScreenPoint at = scattered_point(9, i, j, s, samples);
        const double x = at.x - i, y = at.y - j;
        ASSERT_TRUE(x >= 0 && x < 1 && y >= 0 && y < 1) << x << " " << y;
        // Samples s = c + m r stand in cell row r, the last of which may be short.
        rows.insert(static_cast<int>(y * samples));
        strips.insert(static_cast<int>(x * n * m));
        cells.insert({static_cast<int>(x * m), s / m});
      }
      const auto all = static_cast<std::size_t>(samples);
      ASSERT_EQ(rows.size(), all) << samples;
      ASSERT_EQ(strips.size(), all) << samples;
      ASSERT_EQ(cells.size(), all) << samples;
    }
  }
}

TEST(SampleRandom, SeedPixelAndSampleEachMove) {
  const ScreenPoint one = scattered_point(1, 10, 20, 3, 16);
  EXPECT_EQ(scattered_point(1, 10, 20, 3, 16), one);
  EXPECT_NE(scattered_point(2, 10, 20, 3, 16), one);
  EXPECT_NE(scattered_point(1, 10, 20, 4, 16), one);
  const auto within = [](ScreenPoint at) {
    return ScreenPoint{at.x - std::floor(at.x), at.y - std::floor(at.y)};
  };
  EXPECT_NE(within(scattered_point(1, 11, 20, 3, 16)), within(one));
  EXPECT_NE(within(scattered_point(1, 10, 21, 3, 16)), within(one));
  EXPECT_NE(within(scattered_point(1, 20, 10, 3, 16)), within(one));
}

// One point in each pixel is uniform: the moments of 100,000 pixels, within 5 sigma.
TEST(SampleRandom, PlacesAreUniform) {
  for (const int samples : {1, 7, 16}) {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    const int pixels = 100'000;
    for (int p = 0; p < pixels; ++p) {
      const int i = p % 317, j = p / 317;
      const ScreenPoint at = scattered_point(5, i, j, p % samples, samples);
      const double u = at.x - i - 0.5, v = at.y - j - 0.5;
      x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
    }
    const double sigma = 1 / std::sqrt(pixels);
    EXPECT_LT(std::abs(x / pixels), 5 * sigma * std::sqrt(1 / 12.0)) << samples;
    EXPECT_LT(std::abs(y / pixels), 5 * sigma * std::sqrt(1 / 12.0)) << samples;
    EXPECT_LT(std::abs(xx / pixels - 1 / 12.0), 5 * sigma * std::sqrt(1 / 180.0)) << samples;
    EXPECT_LT(std::abs(yy / pixels - 1 / 12.0), 5 * sigma * std::sqrt(1 / 180.0)) << samples;
    if (samples == 1) {
      EXPECT_LT(std::abs(xy / pixels), 5 * sigma / 12.0);
    }
  }
}

// The share of a pixel's points on one side of a line through it.
template <typename Inside>
double coverage(int i, int j, int samples, std::uint64_t seed, Inside inside) {
  int count = 0;
  for (int s = 0; s < samples; ++s) {
    const ScreenPoint at = scattered_point(seed, i, j, s, samples);
    count += inside(at.x - i, at.y - j);
  }
  return double(count) / samples;
}

TEST(SampleRandom, AnEdgeIsCoverageToASample) {
  for (const int samples : {1, 4, 7, 8, 12, 13, 16, 64, 100, 256, 4096}) {
    const int m = static_cast<int>(std::sqrt(samples)), n = (samples + m - 1) / m;
    const int missing = m * n - samples;  // strips without a point
    for (int p = 0; p < 60; ++p) {
      const double c = (p + 0.5) / 60;
      const double below = coverage(p, 3, samples, 7, [&](double, double y) { return y < c; });
      ASSERT_LT(std::abs(below - c), 1.0 / samples) << samples;
      const double left = coverage(p, 4, samples, 7, [&](double x, double) { return x < c; });
      ASSERT_LT(std::abs(left - c), (1.0 + missing) / samples) << samples;
      // A slanted line crosses m + n - 1 cells at most; the others are wholly on one side.
      if (missing) continue;
      const double slanted =
          coverage(p, 5, samples, 7, [&](double x, double y) { return x + y < 2 * c; });
      const double area = c < 0.5 ? 2 * c * c : 1 - 2 * (1 - c) * (1 - c);
      ASSERT_LE(std::abs(slanted - area), (m + n - 1.0) / samples) << samples;
    }
  }
}

TEST(SampleRandom, ARenderedEdgeIsCoverage) {
  for (const double covered : {0.01, 0.25, 0.3, 0.5, 0.77, 0.99}) {
    test::SceneBuilder build;
    Scene scene = build.finish(build.cube({-9, -9, -1}, {covered, 9, 0}));
    scene.surfaces[0].first = {glm::dvec3(1), glm::dvec3(0), 0, 1, 0, 0};
    scene.lighting.ambient = glm::dvec3(1);
    scene.camera = {{6, 4}, {0, 0, 0}, {0, 0, -1}, 5, {0, 1, 0}, true, 1, false};
    RenderOptions options = scattered(256);
    options.size = {6, 4};
    const Planes planes = render(scene, options).planes;
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_EQ(planes.channel[2][6 * j + 2], 255);
      EXPECT_EQ(planes.channel[2][6 * j + 4], 0);
      EXPECT_LE(std::abs(planes.channel[2][6 * j + 3] / 255.0 - covered), 1 / 256.0 + 0.5 / 255);
    }
  }
}

TEST(SampleRandom, APixelIsTheRoundedMeanOfItsSamples) {
  for (const int samples : {1, 2, 7, 16, 4096}) {
    AntialiasOptions options = scattered(samples, 3).antialias;
    const Region region{5, 2, 9, samples > 1000 ? 16 : 7};  // 4096: more than one batch
    Recorder recorder{test::noise, {}};
    Planes planes;
    AntialiasCounts counts;
    ASSERT_TRUE(sample_random(region, options, recorder.source(), planes, counts));
    EXPECT_EQ(counts.points, planes.size.pixels() * static_cast<std::size_t>(samples));
    EXPECT_EQ(recorder.times, counts.points);
    EXPECT_TRUE(counts.divided.empty());
    for (int p = 0; p < region.width * region.height; ++p) {
      double sum = 0;
      for (int s = 0; s < samples; ++s)
        sum += test::noise(scattered_point(3, 5 + p % 9, 2 + p / 9, s, samples)).r;
      ASSERT_EQ(planes.channel[0][static_cast<std::size_t>(p)], std::floor(sum / samples + 0.5));
    }
  }
}

TEST(SampleRandom, OneSampleIsReproducibleAndDiffersBySeed) {
  const Scene scene = test::random_scene(7, 9, false);
  const RenderResult first = render(scene, scattered(1));
  EXPECT_EQ(first.counts.primary, 60u * 44u);
  EXPECT_TRUE(render(scene, scattered(1)).planes == first.planes);
  EXPECT_FALSE(render(scene, scattered(1, 2)).planes == first.planes);
}

TEST(SampleRandom, ThreadsRegionsEnginesAndSparedRaysDoNotShow) {
  for (const std::uint64_t seed : {2u, 6u, 7u}) {
    const Scene scene = test::random_scene(seed, 9, seed % 2 == 0);
    for (const auto precision : {Precision::double_, Precision::float_}) {
      RenderOptions options = scattered(7, seed);
      options.precision = precision;
      options.threads = 1;
      const RenderResult one = render(scene, options);
      EXPECT_TRUE(one.effects.antialias);
      for (const int threads : {2, 7}) {
        options.threads = threads;
        const RenderResult many = render(scene, options);
        EXPECT_TRUE(many.planes == one.planes);
        EXPECT_EQ(many.counts.shadow, one.counts.shadow);
      }
      RenderOptions all = options;
      all.trace.allowed_effects.exhaustive = true;
      EXPECT_TRUE(render(scene, all).planes == one.planes);
      RenderOptions roth = options;
      roth.trace.engine = Engine::roth;
      EXPECT_TRUE(render(scene, roth).planes == one.planes);
      for (const Region region : {Region{0, 0, 60, 44}, {59, 43, 1, 1}, {13, 7, 31, 30}}) {
        options.region = region;
        expect_crop(render(scene, options).planes, one.planes, region);
      }
    }
  }
}

TEST(SampleRandom, HardSizesAndBadOptions) {
  const Scene scene = test::random_scene(7, 9, false);
  for (const ImageSize size : {ImageSize{1, 1}, {1, 19}, {19, 1}, {17, 31}}) {
    RenderOptions options = scattered(5);
    options.size = size;
    const RenderResult result = render(scene, options);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.planes.size, size);
    EXPECT_EQ(result.counts.primary, 5 * size.pixels());
  }
  for (const int samples : {0, -1, 4097})
    EXPECT_THROW(render(scene, scattered(samples)), std::invalid_argument);
}

TEST(SampleRandom, AStopEndsIt) {
  std::stop_source stop;
  RenderOptions options = scattered(16);
  options.threads = 1;
  const RenderResult stopped = render(
      test::random_scene(7, 9, false), options, [&](double) { stop.request_stop(); },
      stop.get_token());
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.counts.primary, 256u);
}

}  // namespace
}  // namespace sir
