// Whitted's subdivision against a plain recursion, and on real scenes.
#include "tracer/sample_adaptive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sample_recorder.h"
#include "tests/scene_builder.h"

namespace sir {
namespace {

using test::expect_crop;
using test::Recorder;

// The definition, word for word: a pixel on its own, by recursion.
struct Naive {
  test::Painting painting;
  AntialiasOptions options;
  std::set<ScreenPoint> asked;
  std::vector<std::uint64_t> divided = std::vector<std::uint64_t>(AntialiasOptions::kMaxLevels);

  Rgb8 look(double x, double y) {
    asked.insert({x, y});
    return painting({x, y});
  }

  // The mean of a square; exact, as all are multiples of a power of two.
  glm::dvec3 square(double x, double y, double side, int level) {
    const Rgb8 k[] = {look(x, y), look(x + side, y), look(x, y + side), look(x + side, y + side)};
    int differ = 0;
    glm::dvec3 sum(0);
    for (const Rgb8& a : k) {
      sum += glm::dvec3(a.r, a.g, a.b);
      for (const Rgb8& b : k) differ = std::max({differ, a.r - b.r, a.g - b.g, a.b - b.b});
    }
    if (level == options.levels || differ <= options.threshold) return sum / 4.0;
    ++divided[static_cast<std::size_t>(level)];
    const double h = side / 2;
    return (square(x, y, h, level + 1) + square(x + h, y, h, level + 1) +
            square(x, y + h, h, level + 1) + square(x + h, y + h, h, level + 1)) /
           4.0;
  }

  Planes image(const Region& region) {
    Planes planes(ImageSize{region.width, region.height});
    std::size_t p = 0;
    for (int j = 0; j < region.height; ++j)
      for (int i = 0; i < region.width; ++i) {
        const auto mean = glm::floor(square(region.x + i, region.y + j, 1, 0) + 0.5);
        planes.set(p++, {static_cast<std::uint8_t>(mean.r), static_cast<std::uint8_t>(mean.g),
                         static_cast<std::uint8_t>(mean.b)});
      }
    return planes;
  }
};

void expect_as_defined(test::Painting painting, const Region& region, int threshold, int levels) {
  AntialiasOptions options;
  options.threshold = threshold;
  options.levels = levels;
  Naive naive{painting, options, {}};
  const Planes expected = naive.image(region);
  Recorder recorder{painting, {}};
  Planes planes;
  AntialiasCounts counts;
  ASSERT_TRUE(sample_adaptive(region, options, recorder.source(), planes, counts));
  EXPECT_TRUE(planes == expected);
  EXPECT_TRUE(recorder.asked == naive.asked) << "other points than were called for";
  EXPECT_EQ(recorder.times, recorder.asked.size()) << "a point was traced twice";
  EXPECT_EQ(counts.points, recorder.times);
  naive.divided.resize(static_cast<std::size_t>(levels));
  EXPECT_EQ(counts.divided, naive.divided);
}

TEST(SampleAdaptive, IsWhatItsDefinitionSaysAndTracesEachPointOnce) {
  for (int levels = 0; levels <= 6; ++levels)
    for (const int threshold : {0, 16, 254, 255}) {
      SCOPED_TRACE(testing::Message() << levels << " levels, threshold " << threshold);
      // All of its kinds of pixels, without too many points for a set.
      const Region region = levels <= 3 ? Region{0, 0, 70, 50} : Region{24, 15, 21, 17};
      expect_as_defined(test::shapes, region, threshold, levels);
    }
  for (int levels = 0; levels <= 3; ++levels)
    for (const int threshold : {0, 100, 200, 250}) {
      SCOPED_TRACE(testing::Message() << levels << " levels, threshold " << threshold);
      expect_as_defined(test::noise, {3, 5, 24, 19}, threshold, levels);
    }
}

// Larger than the rectangles that it works in: 2^16 pixels at 2 levels, 2^10 at 6.
TEST(SampleAdaptive, PointsBetweenRectanglesAreSharedToo) {
  expect_as_defined(test::noise, {1, 2, 300, 280}, 150, 1);
  expect_as_defined(test::shapes, {0, 0, 97, 65}, 3, 6);
  expect_as_defined(test::noise, {0, 0, 70, 33}, 252, 6);
  expect_as_defined(test::noise, {0, 0, 1, 2100}, 240, 6);
  expect_as_defined(test::noise, {0, 0, 2100, 1}, 240, 6);
}

TEST(SampleAdaptive, HardSizes) {
  for (const Region region : {Region{0, 0, 1, 1}, {7, 9, 1, 31}, {0, 0, 31, 1}, {0, 0, 17, 31}})
    for (const int threshold : {0, 255}) expect_as_defined(test::noise, region, threshold, 2);
}

TEST(SampleAdaptive, ThresholdZeroOnNoiseIsARegularGrid) {
  const Region region{0, 0, 9, 7};
  AntialiasOptions options;
  options.threshold = 0;
  for (options.levels = 0; options.levels <= 4; ++options.levels) {
    Recorder recorder{test::noise, {}};
    Planes planes;
    AntialiasCounts counts;
    ASSERT_TRUE(sample_adaptive(region, options, recorder.source(), planes, counts));
    const int n = 1 << options.levels;
    EXPECT_EQ(counts.points, static_cast<std::uint64_t>((9 * n + 1) * (7 * n + 1)));
    for (int p = 0; p < 63; ++p) {
      int sum = 0;  // the trapezoid rule: corners of the pixel once, sides twice, inside four times
      for (int v = 0; v <= n; ++v)
        for (int u = 0; u <= n; ++u)
          sum += (u == 0 || u == n ? 1 : 2) * (v == 0 || v == n ? 1 : 2) *
                 test::noise({p % 9 + double(u) / n, p / 9 + double(v) / n}).r;
      ASSERT_EQ(planes.channel[0][static_cast<std::size_t>(p)], (sum + 2 * n * n) / (4 * n * n));
    }
  }
}

// A cube's edge at x = 3 + covered, seen in parallel: pixels of 1 x 1.
Scene edge(double covered) {
  test::SceneBuilder build;
  Scene scene = build.finish(build.cube({-9, -9, -1}, {covered, 9, 0}));
  scene.surfaces[0].first = {glm::dvec3(1), glm::dvec3(0), 0, 1, 0, 0};
  scene.lighting.ambient = glm::dvec3(1);
  scene.camera = {{6, 4}, {0, 0, 0}, {0, 0, -1}, 5, {0, 1, 0}, true, 1, false};
  return scene;
}

RenderOptions adaptive(int threshold, int levels) {
  RenderOptions options;
  options.size = {60, 44};
  options.antialias.mode = Antialias::adaptive;
  options.antialias.threshold = threshold;
  options.antialias.levels = levels;
  return options;
}

TEST(SampleAdaptive, AnEdgeIsCoverageToHalfAFinestSquare) {
  for (int levels = 0; levels <= 6; ++levels)
    for (const double covered : {0.01, 0.25, 0.3, 0.5, 0.77, 0.99}) {
      RenderOptions options = adaptive(16, levels);
      options.size = {6, 4};
      const Planes planes = render(edge(covered), options).planes;
      for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_EQ(planes.channel[0][6 * j + 2], 255);
        EXPECT_EQ(planes.channel[0][6 * j + 4], 0);
        EXPECT_LE(std::abs(planes.channel[0][6 * j + 3] / 255.0 - covered),
                  std::ldexp(0.5, -levels) + 0.5 / 255)
            << covered << " at " << levels;
      }
    }
}

TEST(SampleAdaptive, RenderedIsWhatTheSamplesSay) {
  const Scene scene = test::random_scene(7, 9, false);
  for (const auto precision : {Precision::double_, Precision::float_}) {
    RenderOptions options = adaptive(255, 2);
    options.precision = precision;
    const RenderResult four = render(scene, options);
    EXPECT_TRUE(four.effects.antialias);
    EXPECT_EQ(four.counts.primary, 61u * 45u);
    EXPECT_EQ(four.antialias.points, 61u * 45u);
    PointSampler sampler(scene, options);
    std::vector<ScreenPoint> corners;
    for (int j = 0; j <= 44; ++j)
      for (int i = 0; i <= 60; ++i) corners.push_back({double(i), double(j)});
    std::vector<Rgb8> seen(corners.size());
    ASSERT_TRUE(sampler.trace(corners, seen));
    for (std::size_t p = 0; p < 60 * 44; ++p) {
      const std::size_t at = p / 60 * 61 + p % 60;
      const int sum = seen[at].g + seen[at + 1].g + seen[at + 61].g + seen[at + 62].g;
      ASSERT_EQ(four.planes.channel[1][p], (sum + 2) / 4);
    }
  }
}

TEST(SampleAdaptive, ThreadsRegionsEnginesAndSparedRaysDoNotShow) {
  std::uint64_t divided = 0;
  for (const std::uint64_t seed : {2u, 6u, 7u, 15u}) {
    const Scene scene = test::random_scene(seed, 9, seed % 2 == 0);
    for (const auto precision : {Precision::double_, Precision::float_}) {
      RenderOptions options = adaptive(8, 3);
      options.precision = precision;
      options.threads = 1;
      const RenderResult one = render(scene, options);
      divided += one.antialias.divided[2];
      for (const int threads : {2, 7}) {
        options.threads = threads;
        const RenderResult many = render(scene, options);
        EXPECT_TRUE(many.planes == one.planes);
        EXPECT_EQ(many.antialias.points, one.antialias.points);
        EXPECT_EQ(many.antialias.divided, one.antialias.divided);
        EXPECT_EQ(many.counts.shadow, one.counts.shadow);
        EXPECT_EQ(many.counts.primary, many.antialias.points);
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
  EXPECT_GT(divided, 1000u);
}

TEST(SampleAdaptive, OnlyWhereItIsAllowed) {
  const Scene scene = test::random_scene(7, 9, false);
  RenderOptions options = adaptive(16, 2);
  options.trace.allowed_effects.antialias = false;
  const RenderResult result = render(scene, options);
  EXPECT_FALSE(result.effects.antialias);
  EXPECT_EQ(result.antialias.points, 0u);
  options.antialias.mode = Antialias::none;
  EXPECT_TRUE(result.planes == render(scene, options).planes);
}

TEST(SampleAdaptive, RefusesOptionsOutOfRange) {
  const Scene scene = edge(0.5);
  for (const auto& [threshold, levels] : {std::pair{-1, 2}, {256, 2}, {16, -1}, {16, 7}})
    EXPECT_THROW(render(scene, adaptive(threshold, levels)), std::invalid_argument);
  RenderOptions outside = adaptive(16, 2);
  outside.region = {50, 0, 11, 1};
  EXPECT_THROW(render(scene, outside), std::invalid_argument);
}

TEST(SampleAdaptive, ProgressRisesToOneAndAStopEndsIt) {
  const Scene scene = test::random_scene(7, 9, false);
  double last = 0;
  bool rising = true;
  render(scene, adaptive(0, 3), [&](double done) {
    rising = rising && done >= last;
    last = done;
  });
  EXPECT_TRUE(rising);
  EXPECT_DOUBLE_EQ(last, 1);

  std::stop_source stop;
  RenderOptions single = adaptive(0, 3);
  single.threads = 1;
  const RenderResult stopped = render(
      scene, single, [&](double) { stop.request_stop(); }, stop.get_token());
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.counts.primary, 256u);  // one piece of work
  EXPECT_EQ(stopped.planes.size, single.size);
}

}  // namespace
}  // namespace sir
