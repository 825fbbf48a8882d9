// The hesitation lens shows what is fragile, and nothing else.
#include "tracer/hesitation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scene_builder.h"

namespace sir {
namespace {

using test::SceneBuilder;

// Seen along -Z in parallel, one pixel of 0.25 x 0.25 after the other.
Scene seen(Scene scene) {
  scene.camera = {{4, 4}, {0, 0, 0}, {0, 0, -1}, 10, {0, 1, 0}, true, 1, false};
  return scene;
}

RenderOptions small() {
  RenderOptions options;
  options.size = {16, 16};
  return options;
}

TEST(Hesitation, SolidsApartAreSure) {
  SceneBuilder build;
  const auto both = build.combine(Operation::union_of, build.cube({-2, -2, -1}, {0, 0, 0}),
                                  build.cube({0.5, 0.5, 0}, {1.5, 1.5, 1}));
  const HesitationMap map = find_hesitation(seen(build.finish(both)), small());
  EXPECT_EQ(map.pixels.rounding, 0u);
  EXPECT_EQ(map.pixels.precision, 0u);
  EXPECT_TRUE(map.nodes.empty());
  EXPECT_EQ(std::count(map.causes.begin(), map.causes.end(), 0), 256);
}

TEST(Hesitation, FlushFacesHangOnRoundingWhereTheyAreSeen) {
  SceneBuilder build;
  // Fronts in one plane, overlapping in 4 x 4 pixels; the third stands apart.
  const auto flush = build.combine(Operation::union_of, build.cube({-2, -2, -1}, {0, 0, 0.3}, 1, 5),
                                   build.cube({-1, -1, -2}, {1, 1, 0.3}, 1, 6));
  const auto all =
      build.combine(Operation::union_of, flush, build.cube({1, 1, 0}, {2, 2, 2}, 1, 7));
  const HesitationMap map = find_hesitation(seen(build.finish(all)), small());
  EXPECT_EQ(map.pixels.rounding, 16u);
  ASSERT_EQ(map.nodes.size(), 2u);
  EXPECT_EQ(map.nodes.at(5).rounding, 16u);
  EXPECT_EQ(map.nodes.at(6).rounding, 16u);
  EXPECT_EQ(map.causes[8 * 16 + 4], kRounding);  // row 8 is just below the middle
  EXPECT_EQ(map.causes[0], 0);
}

TEST(Hesitation, ShellBelowFloatHangsOnThePrecision) {
  SceneBuilder build;
  const auto shell = build.combine(Operation::difference, build.cube({-1, -1, -1}, {1, 1, 0}, 1, 1),
                                   build.cube({-1.5, -1.5, -1.5}, {1.5, 1.5, -1e-9}, 1, 2));
  const HesitationMap map = find_hesitation(seen(build.finish(shell)), small());
  EXPECT_EQ(map.pixels.precision, 64u);  // 8 x 8 pixels see the plate
  EXPECT_EQ(map.pixels.rounding, 0u);
  EXPECT_EQ(map.nodes.at(1).precision, 64u);
  EXPECT_EQ(map.nodes.at(2).precision, 64u);
}

TEST(Hesitation, DoesNotDependOnThreadsAndKeepsToTheRegion) {
  const Scene scene = test::random_scene(3, 12, true);
  RenderOptions options;
  options.size = {96, 72};
  options.threads = 1;
  const HesitationMap one = find_hesitation(scene, options);
  options.threads = 5;
  const HesitationMap five = find_hesitation(scene, options);
  EXPECT_EQ(one.causes, five.causes);
  EXPECT_EQ(one.pixels.rounding, five.pixels.rounding);
  EXPECT_EQ(one.nodes.size(), five.nodes.size());
  EXPECT_GT(one.pixels.rounding, 0u);

  options.region = {40, 20, 33, 35};
  const HesitationMap part = find_hesitation(scene, options);
  ASSERT_EQ(part.size, (ImageSize{33, 35}));
  for (int j = 0; j < 35; ++j)
    for (int i = 0; i < 33; ++i)
      ASSERT_EQ(part.causes[static_cast<std::size_t>(j * 33 + i)],
                one.causes[static_cast<std::size_t>((20 + j) * 96 + 40 + i)]);
}

TEST(Hesitation, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const auto map = find_hesitation(test::random_scene(3, 5, true), small(), {}, stop.get_token());
  EXPECT_FALSE(map.complete);
}

TEST(Hesitation, MarksKeepTheRestAsDarkGreys) {
  Planes image(ImageSize{4, 1});
  for (std::size_t p = 0; p < 4; ++p) image.set(p, {255, 255, 255});
  HesitationMap map;
  map.size = image.size;
  map.causes = {0, kPrecision, kRounding, kPrecision | kRounding};
  const Planes result = marked(image, map);
  EXPECT_EQ(result.at(0), (Rgb8{85, 85, 85}));
  for (std::size_t p = 1; p < 4; ++p)
    for (std::size_t q = 0; q < p; ++q) EXPECT_NE(result.at(p), result.at(q));
}

}  // namespace
}  // namespace sir
