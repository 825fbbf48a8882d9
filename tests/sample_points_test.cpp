// Points of the screen against pixels.
#include "tracer/sample_points.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/scene_builder.h"
#include "tracer/tiles.h"

namespace sir {
namespace {

RenderOptions small(Precision precision) {
  RenderOptions options;
  options.size = {53, 41};
  options.precision = precision;
  return options;
}

std::vector<ScreenPoint> centres(ImageSize size) {
  std::vector<ScreenPoint> points;
  for (int j = 0; j < size.height; ++j)
    for (int i = 0; i < size.width; ++i) points.push_back({i + 0.5, j + 0.5});
  return points;
}

// What does not hang on which rays go together.
void expect_the_same_rays(const RayCounts& a, const RayCounts& b) {
  EXPECT_EQ(a.primary, b.primary);
  EXPECT_EQ(a.reflected, b.reflected);
  EXPECT_EQ(a.refracted, b.refracted);
  EXPECT_EQ(a.shadow, b.shadow);
  EXPECT_EQ(a.filtered, b.filtered);
  EXPECT_EQ(a.spared, b.spared);
  EXPECT_EQ(a.exact, b.exact);
  EXPECT_EQ(a.doubtful, b.doubtful);
}

TEST(PointSampler, PixelCentresGiveThePixels) {
  for (const double away : {0.0, 1e6}) {  // where float moves the origin
    const Scene scene = test::moved(test::random_scene(7, 9, false), 1, glm::dvec3(away));
    for (const auto& [precision, packets] : {std::pair{Precision::double_, true},
                                             {Precision::float_, true},
                                             {Precision::double_, false}}) {
      RenderOptions options = small(precision);
      options.trace.packets = packets;
      const RenderResult plain = render(scene, options);
      const auto points = centres(options.size);
      for (const int threads : {1, 2, 7}) {
        options.threads = threads;
        PointSampler sampler(scene, options);
        std::vector<Rgb8> seen(points.size());
        // In two calls, to see that what is kept between them does no harm.
        const std::size_t half = 1000;
        ASSERT_TRUE(sampler.trace(std::span(points).first(half), std::span(seen).first(half)));
        ASSERT_TRUE(sampler.trace(std::span(points).subspan(half), std::span(seen).subspan(half)));
        for (std::size_t p = 0; p < points.size(); ++p) ASSERT_EQ(seen[p], plain.planes.at(p));
        const RayCounts counts = sampler.counts();
        expect_the_same_rays(counts, plain.counts);
        EXPECT_EQ(counts.packets > 0, packets);
        if (packets) continue;
        EXPECT_EQ(counts.spans, plain.counts.spans);
        EXPECT_EQ(counts.costs, plain.counts.costs);
      }
    }
  }
}

TEST(PointSampler, NoPointsAreDoneAtOnce) {
  PointSampler sampler(test::random_scene(7, 9, false), small(Precision::double_));
  EXPECT_TRUE(sampler.trace({}, {}));
  EXPECT_EQ(sampler.counts().primary, 0u);
}

TEST(PointSampler, ASourceReportsItsShare) {
  PointSampler sampler(test::random_scene(7, 9, false), small(Precision::double_));
  std::vector<double> told;
  const auto source = sampler.source([&](double done) { told.push_back(done); }, {});
  const auto points = centres({53, 41});
  std::vector<Rgb8> seen(points.size());
  ASSERT_TRUE(source(points, seen, {0.25, 0.75}));
  ASSERT_FALSE(told.empty());
  EXPECT_GT(told.front(), 0.25);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_DOUBLE_EQ(told.back(), 0.75);
}

TEST(PointSampler, AStopTakesEffectWithinAPiece) {
  RenderOptions options = small(Precision::double_);
  options.threads = 1;
  PointSampler sampler(test::random_scene(7, 9, false), options);
  const auto points = centres(options.size);
  std::vector<Rgb8> seen(points.size());
  std::stop_source stop;
  EXPECT_FALSE(sampler.trace(
      points, seen, [&](double) { stop.request_stop(); }, stop.get_token()));
  EXPECT_EQ(sampler.counts().primary, 256u);
  EXPECT_FALSE(sampler.trace(points, seen, {}, stop.get_token()));
  EXPECT_EQ(sampler.counts().primary, 256u);
}

TEST(Pieces, EachIsDoneOnceByAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7, 100})
    for (const std::int64_t count : {0, 1, 5, 1000}) {
      std::vector<std::atomic<int>> times(static_cast<std::size_t>(count));
      std::atomic<int> workers{0};
      const auto make = [&]() -> PieceWorker {
        ++workers;
        return [&](std::int64_t piece) { ++times[static_cast<std::size_t>(piece)]; };
      };
      EXPECT_TRUE(for_each_piece(count, threads, make, {}, {}));
      for (const auto& n : times) ASSERT_EQ(n, 1);
      EXPECT_LE(workers, std::max<std::int64_t>(std::min<std::int64_t>(threads, count), 1));
    }
}

TEST(Pieces, WhatAWorkerThrowsComesOut) {
  const auto make = []() -> PieceWorker {
    return [](std::int64_t piece) {
      if (piece == 3) throw std::runtime_error("three");
    };
  };
  EXPECT_THROW(for_each_piece(100, 3, make, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace sir
