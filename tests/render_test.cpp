// Properties of whole images.
#include "tracer/render.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/scene_builder.h"

namespace sir {
namespace {

RenderOptions small() {
  RenderOptions options;
  options.size = {80, 60};
  return options;
}

int difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST(Render, SamePlanesForAnyNumberOfThreads) {
  RenderOptions options = small();
  const Scene scene = test::random_scene(7, 9, false);
  options.threads = 1;
  const auto one = render(scene, options);
  for (const int threads : {2, 7, 64}) {
    options.threads = threads;
    const auto many = render(scene, options);
    EXPECT_EQ(many.planes, one.planes);
    EXPECT_EQ(many.counts.primary, one.counts.primary);
    EXPECT_EQ(many.counts.shadow, one.counts.shadow);
    EXPECT_EQ(many.counts.spans, one.counts.spans);
  }
}

TEST(Render, PowersOfTwoScaleWithoutChangingAByte) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = test::random_scene(seed, 8, seed % 2 == 0);
    const Planes usual = render(scene, small()).planes;
    for (const int exponent : {-40, -20, 7, 40})
      ASSERT_EQ(render(test::moved(scene, std::ldexp(1, exponent), {}), small()).planes, usual)
          << "seed " << seed << " scale 2^" << exponent;
    RenderOptions single = small();
    single.precision = Precision::float_;
    const Planes usual_single = render(scene, single).planes;
    for (const int exponent : {-20, -10, 7, 20})
      ASSERT_EQ(render(test::moved(scene, std::ldexp(1, exponent), {}), single).planes,
                usual_single)
          << "seed " << seed << " float, scale 2^" << exponent;
  }
}

TEST(Render, MovingTheSceneMovesNoPixels) {
  std::size_t far_off = 0, pixels = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = test::random_scene(seed, 8, false);
    const Planes usual = render(scene, small()).planes;
    const Planes moved = render(test::moved(scene, 1, {1000, -1000, 1000}), small()).planes;
    for (std::size_t p = 0; p < usual.size.pixels(); ++p)
      far_off += difference(usual.at(p), moved.at(p)) > 2;
    pixels += usual.size.pixels();
  }
  EXPECT_LE(static_cast<double>(far_off), 0.0005 * static_cast<double>(pixels));
}

TEST(Render, FloatSeesASceneFarAwayAsNearTheOrigin) {
  // Moved by numbers that double holds and float does not.
  RenderOptions options = small();
  options.precision = Precision::float_;
  const Scene scene = test::random_scene(7, 8, false);
  const Planes here = render(scene, options).planes;
  for (const double away : {1e4 + 1, 1e6 + 1, 1e8 + 1}) {
    const Scene moved = test::moved(scene, 1, {away, -away, 2 * away});
    const Planes there = render(moved, options).planes;
    int differ = 0;
    for (std::size_t p = 0; p < here.size.pixels(); ++p)
      differ += difference(here.at(p), there.at(p)) > 2;
    EXPECT_LE(differ, 3) << away;  // silhouettes
  }
}

TEST(Render, MirroredSceneGivesTheMirroredImage) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Scene scene = test::random_scene(seed, 8, false);
    scene.camera.normal = {0, -0.4, -1};  // in the plane of the mirror
    Scene mirrored = scene;
    for (CsgNode& node : mirrored.tree.nodes) {
      for (int line = 0; line < 3; ++line) node.placement.linear[line].x *= -1;
      node.placement.translation.x *= -1;
    }
    for (Light& light : mirrored.lighting.lights) light.position.x *= -1;
    const Planes a = render(scene, small()).planes, b = render(mirrored, small()).planes;
    for (std::size_t j = 0; j < 60; ++j)
      for (std::size_t i = 0; i < 80; ++i)
        ASSERT_EQ(a.at(j * 80 + i), b.at(j * 80 + 79 - i)) << seed << ": " << i << " " << j;
  }
}

TEST(Render, UnionCommutes) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Scene scene = test::random_scene(seed, 10, false);
    const Planes usual = render(scene, small()).planes;
    for (CsgNode& node : scene.tree.nodes)
      if (node.composite && node.operation != Operation::difference)
        std::swap(node.left, node.right);
    ASSERT_EQ(render(scene, small()).planes, usual);
  }
}

TEST(Render, LitSideOfAConvexSolidHasNoDarkPixel) {
  std::mt19937_64 random(8);
  for (int n = 0; n < 12; ++n) {
    test::SceneBuilder convex;
    constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere,
                                        PrimitiveKind::cone, PrimitiveKind::cylinder};
    Scene scene = test::random_scene(0, 1, false);
    Placement placement = test::random_placement(random, 2, true);
    placement.translation *= 0.3;
    const auto id = convex.primitive(kKinds[n % 4], placement);
    scene.tree = convex.finish(id).tree;
    scene.surfaces = {convex.surface(1)};
    scene.surfaces[0].first = {glm::dvec3(0), glm::dvec3(1), 0, 1, 0, 0};
    // The light in the eye's place: everything seen is lit.
    const glm::dvec3 n_dir = glm::normalize(scene.camera.normal);
    const glm::dvec3 eye = scene.camera.target - 2 * scene.camera.distance * n_dir;
    scene.lighting = {{0, 0, 1}, glm::dvec3(0), {{eye, glm::dvec3(1000)}}};
    for (const auto precision : {Precision::double_, Precision::float_}) {
      RenderOptions options = small();
      options.precision = precision;
      const Planes planes = render(scene, options).planes;
      std::size_t seen = 0;
      for (std::size_t p = 0; p < planes.size.pixels(); ++p) {
        if (planes.at(p) == Rgb8{0, 0, 255}) continue;
        ++seen;
        ASSERT_GT(planes.at(p).r, 0) << "solid " << n << " pixel " << p;
      }
      EXPECT_GT(seen, 50u);
    }
  }
}

TEST(Render, RegionIsThatPartOfTheImage) {
  RenderOptions options = small();
  const Scene scene = test::random_scene(2, 8, false);
  const Planes whole = render(scene, options).planes;
  options.region = {13, 7, 41, 37};
  const Planes part = render(scene, options).planes;
  ASSERT_EQ(part.size, (ImageSize{41, 37}));
  for (std::size_t j = 0; j < 37; ++j)
    for (std::size_t i = 0; i < 41; ++i)
      ASSERT_EQ(part.at(j * 41 + i), whole.at((j + 7) * 80 + i + 13));
  options.region = {60, 0, 21, 60};
  EXPECT_THROW(render(scene, options), std::invalid_argument);
}

TEST(Render, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(render(test::random_scene(2, 8, false), small(), {}, stop.get_token()).complete);
}

TEST(Render, ProgressRisesToOne) {
  double last = 0;
  bool rising = true;
  render(test::random_scene(2, 3, false), small(), [&](double done) {
    rising = rising && done > last;
    last = done;
  });
  EXPECT_TRUE(rising);
  EXPECT_EQ(last, 1);
}

TEST(Render, FloatIsCloseToDouble) {
  RenderOptions options = small();
  std::size_t far_off = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = test::random_scene(seed, 8, false);
    options.precision = Precision::double_;
    const Planes exact = render(scene, options).planes;
    options.precision = Precision::float_;
    const Planes single = render(scene, options).planes;
    EXPECT_NE(exact, Planes(exact.size));
    for (std::size_t p = 0; p < exact.size.pixels(); ++p)
      far_off += difference(exact.at(p), single.at(p)) > 2;
  }
  EXPECT_LT(far_off, 8u * 4800u / 100u);
}

TEST(Render, TracedPixelIsThePixel) {
  const Scene scene = test::random_scene(3, 8, false);
  const Planes planes = render(scene, small()).planes;
  for (int i = 0; i < 80; i += 7)
    EXPECT_EQ(trace_pixel(scene, small(), i, 31).pixel,
              planes.at(31 * 80 + static_cast<std::size_t>(i)));
}

}  // namespace
}  // namespace sir
