// The textbook's formulas see what the robust ones see where nothing is hard, and
// something else where it is.
#include <gtest/gtest.h>

#include "tests/scene_builder.h"
#include "tracer/intersect_exact.h"
#include "tracer/intersect_textbook.h"
#include "tracer/render.h"

namespace sir {
namespace {

constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere, PrimitiveKind::cone,
                                    PrimitiveKind::cylinder};

Planes picture(const Scene& scene, Formulas formulas, ImageSize size = {64, 48}) {
  RenderOptions options;
  options.size = size;
  options.trace.formulas = formulas;
  const RenderResult result = render(scene, options);
  if (formulas == Formulas::textbook) {
    EXPECT_EQ(result.counts.exact, 0u);
  }
  return result.planes;
}

std::size_t differing(const Planes& a, const Planes& b) {
  std::size_t count = 0;
  for (std::size_t p = 0; p < a.size.pixels(); ++p) count += a.at(p) != b.at(p);
  return count;
}

// A scene without lights: white where the solid is, blue where it is not.
Scene silhouette(test::SceneBuilder& build, test::SceneBuilder::Id root) {
  Scene scene = build.finish(root);
  scene.lighting = {{0, 0, 1}, glm::dvec3(1), {}};
  scene.surfaces[0].first = {glm::dvec3(1), glm::dvec3(0), 0, 1, 0, 0};
  scene.camera.normal = {0, 0, -1};
  scene.camera.up = {0, 1, 0};
  scene.camera.parallel = true;
  return scene;
}

TEST(Textbook, SpanIsTheExactOneFromNear) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  int hits = 0, differ = 0;
  for (int n = 0; n < 8000; ++n) {
    const PrimitiveKind kind = kKinds[n % 4];
    const Placement placement = test::random_placement(random, 1, false);
    const glm::dvec3 aim =
        placement.linear * glm::dvec3(any(random), any(random), any(random)) * 0.7 +
        placement.translation;
    const glm::dvec3 way = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    const RayCena<double> ray{{aim - 3.0 * way}, {way}};
    Span<double> exact, span;
    const bool crosses = intersect_exactly(kind, placement, ray, 0.0, exact);
    const bool said = intersect_as_in_textbooks(TextbookLeaf<double>(kind, placement), ray, span);
    if (crosses != said) ++differ;
    if (!crosses || !said) continue;
    ++hits;
    const bool near =
        std::abs(span.enter - exact.enter) < 1e-9 && std::abs(span.leave - exact.leave) < 1e-9;
    differ += !near || span.enter_face != exact.enter_face || span.leave_face != exact.leave_face;
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LE(differ, 4);
}

TEST(Textbook, SeesGenericScenesAsTheRobustWay) {
  std::size_t off = 0, pixels = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Scene scene = test::random_scene(seed, 8, false);
    const Planes robust = picture(scene, Formulas::robust);
    off += differing(robust, picture(scene, Formulas::textbook));
    pixels += robust.size.pixels();
  }
  EXPECT_LE(off * 1000, pixels);
}

TEST(Textbook, EnginesAgreeOnIt) {
  RenderOptions options;
  options.size = {48, 36};
  options.trace.formulas = Formulas::textbook;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Scene scene = test::random_scene(seed, 9, false);
    options.trace.engine = Engine::gates;
    const Planes fast = render(scene, options).planes;
    options.trace.engine = Engine::roth;
    EXPECT_EQ(render(scene, options).planes, fast) << seed;
  }
}

// A ball of radius 1 from 1e8 away: a pixel is white where x^2 + y^2 < 1.
TEST(Textbook, LosesABallFarAway) {
  test::SceneBuilder build;
  Scene scene = silhouette(build, build.sphere({0, 0, 0}, 1));
  scene.camera.target = {0, 0, 0};
  scene.camera.distance = 1e8;
  scene.camera.window = {4, 4};
  const ImageSize size{64, 64};
  const Planes robust = picture(scene, Formulas::robust, size);
  const Planes textbook = picture(scene, Formulas::textbook, size);
  std::size_t wrong = 0;
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) {
      const double x = (2 * i - 63) / 32.0, y = (63 - 2 * j) / 32.0;  // exact
      const auto p = static_cast<std::size_t>(64 * j + i);
      ASSERT_EQ(robust.at(p).r > 0, x * x + y * y < 1) << x << " " << y;
      wrong += textbook.at(p) != robust.at(p);
    }
  EXPECT_GT(wrong, 0u);
}

// A shell of 1e-9 from 1e5 away is as opaque as the ball it is left of.
TEST(Textbook, LosesAThinShell) {
  test::SceneBuilder build;
  const auto ball = build.sphere({0, 0, 0}, 1), hollow = build.sphere({0, 0, 0}, 1 - 1e-9);
  Scene scene = silhouette(build, build.combine(Operation::difference, ball, hollow));
  scene.camera.target = {0, 0, 0};
  scene.camera.normal = {-0.3, -0.4, -1};
  scene.camera.distance = 1e5;
  scene.camera.window = {1, 1};  // all of it is on the ball
  const Planes robust = picture(scene, Formulas::robust);
  const Planes textbook = picture(scene, Formulas::textbook);
  std::size_t wrong = 0;
  for (std::size_t p = 0; p < robust.size.pixels(); ++p) {
    ASSERT_EQ(robust.at(p), (Rgb8{255, 255, 255})) << p;
    wrong += textbook.at(p) != robust.at(p);
  }
  EXPECT_GT(wrong, 0u);
}

// A bore flush with the top of a turned block, 1e7 from the origin: one sees
// through it, but for the textbook's skin. In whole numbers, so that the faces
// coincide exactly.
TEST(Textbook, PutsASkinOnAFlushBore) {
  const glm::dvec3 away(1e7, -3e6, 7e6), x(2, -1, 2), y(2, 2, -1), z(-1, 2, 2);
  Placement block, bore;
  block.linear = glm::dmat3(3.0 * x, y, 5.0 * z);
  block.translation = away - 1.5 * x - 2.5 * z;
  bore.linear = glm::dmat3(0.5 * x, 3.0 * y, 0.5 * z);
  bore.translation = away - 2.0 * y;
  test::SceneBuilder build;
  const auto cube = build.primitive(PrimitiveKind::cube, block);
  const auto cylinder = build.primitive(PrimitiveKind::cylinder, bore);
  Scene scene = silhouette(build, build.combine(Operation::difference, cube, cylinder));
  scene.camera.target = away;
  scene.camera.normal = -y;
  scene.camera.up = z;
  scene.camera.distance = 10;
  scene.camera.window = {1, 1};  // within the bore
  const Planes robust = picture(scene, Formulas::robust);
  const Planes textbook = picture(scene, Formulas::textbook);
  std::size_t wrong = 0;
  for (std::size_t p = 0; p < robust.size.pixels(); ++p) {
    ASSERT_EQ(robust.at(p), (Rgb8{0, 0, 255})) << p;
    wrong += textbook.at(p) != robust.at(p);
  }
  EXPECT_GT(wrong, 0u);
}

// The fixed epsilon: in a scene of size 1e-5 every second boundary is too near.
TEST(Textbook, EpsilonIsBlindInATinyScene) {
  const Scene scene = test::random_scene(5, 8, false);
  const Scene tiny = test::moved(scene, 0x1p-20, {});
  EXPECT_EQ(picture(tiny, Formulas::robust), picture(scene, Formulas::robust));
  const std::size_t wrong =
      differing(picture(tiny, Formulas::textbook), picture(scene, Formulas::textbook));
  EXPECT_GT(wrong, 0u);
}

}  // namespace
}  // namespace sir
