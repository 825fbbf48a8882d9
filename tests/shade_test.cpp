// Equation 2.1 on points worked out by hand.
#include "tracer/shade.h"

#include <gtest/gtest.h>

#include "tests/scene_builder.h"
#include "tracer/ray_shadow.h"
#include "tracer/render.h"

namespace sir {
namespace {

using test::SceneBuilder;

// The floor y = 0 seen from above at (0,0,0) along -y, one light at (3,4,0):
// L = (0.6,0.8,0), N.L = 0.8, E = N = (0,1,0), H = normalize(0.6,1.8,0).
struct Floor {
  SceneBuilder build;
  SceneBuilder::Id floor = build.cube({-5, -1, -5}, {5, 0, 5});

  Floor() {
    build.scene.lighting.ambient = {0.1, 0.2, 0.3};
    build.scene.lighting.lights = {{{3, 4, 0}, {0.5, 1, 0.25}}};
    Coefficients& k = build.surface(1).first;
    k = {{0.5, 0.4, 0.3}, {0.9, 0.5, 0.2}, 0.6, 3, 0, 0};
  }

  glm::dvec3 colour(SceneBuilder::Id root, EffectSet allowed = {}, RayCounts* counts = nullptr) {
    const Scene scene = build.finish(root);
    const Model<double> model(scene, allowed);
    Classifier<double> classifier(model.solid);
    const RayCena<double> ray{{{0, 10, 0}}, {{0, -2, 0}}};
    classifier.begin(ray);
    Boundary<double> boundary;
    EXPECT_TRUE(classifier.next(boundary));
    RayCounts own;
    return shade(model, classifier, hit_at(model, ray, boundary), counts ? *counts : own);
  }
};

void expect_colour(glm::dvec3 got, glm::dvec3 expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], 1e-14) << "channel " << c;
}

const double kHighlight = 0.6 * std::pow(1.8 / std::sqrt(0.36 + 3.24), 3);

TEST(Shade, AmbientDiffuseAndHighlight) {
  Floor f;
  expect_colour(f.colour(f.floor), {0.1 * 0.5 + 0.5 * (0.9 * 0.8 + kHighlight),
                                    0.2 * 0.4 + 1.0 * (0.5 * 0.8 + kHighlight),
                                    0.3 * 0.3 + 0.25 * (0.2 * 0.8 + kHighlight)});
}

TEST(Shade, OpaqueSolidShadowsTheLight) {
  Floor f;
  const auto ball = f.build.sphere({1.5, 2, 0}, 0.5, 2);
  expect_colour(f.colour(f.build.combine(Operation::union_of, f.floor, ball)), {0.05, 0.08, 0.09});
}

TEST(Shade, SolidBehindTheLightCastsNoShadow) {
  Floor f;
  const auto ball = f.build.sphere({6, 8, 0}, 1, 2);
  const auto alone = Floor().colour(0);
  expect_colour(f.colour(f.build.combine(Operation::union_of, f.floor, ball)), alone);
}

TEST(Shade, EveryTransparentBoundaryCountsOnce) {
  Floor f;
  f.build.surface(2).first.transmission = 0.5;
  f.build.surface(2).first.index = 1.5;
  const auto ball = f.build.sphere({1.5, 2, 0}, 0.5, 2);
  const auto root = f.build.combine(Operation::union_of, f.floor, ball);
  expect_colour(f.colour(root), {0.05 + 0.25 * 0.5 * (0.9 * 0.8 + kHighlight),
                                 0.08 + 0.25 * 1.0 * (0.5 * 0.8 + kHighlight),
                                 0.09 + 0.25 * 0.25 * (0.2 * 0.8 + kHighlight)});
  EffectSet no_filter;
  no_filter.filter = false;
  expect_colour(f.colour(root, no_filter), {0.05, 0.08, 0.09});
  EffectSet no_shadow;
  no_shadow.shadow = false;
  expect_colour(f.colour(root, no_shadow), Floor().colour(0));
}

TEST(Shade, LightBelowTheSurfaceCastsNoRayAndCountsNothing) {
  Floor f;
  f.build.scene.lighting.lights[0].position = {3, -0.5, 0};
  RayCounts counts;
  expect_colour(f.colour(f.floor, {}, &counts), {0.05, 0.08, 0.09});
  EXPECT_EQ(counts.shadow, 0u);
  EffectSet all;
  all.exhaustive = true;
  expect_colour(f.colour(f.floor, all, &counts), {0.05, 0.08, 0.09});
  EXPECT_EQ(counts.shadow, 1u);
}

TEST(Shade, DegenerateDirectionsGiveNumbers) {
  Floor f;
  f.build.scene.lighting.lights = {{{0, 0, 0}, {1, 1, 1}},    // on the point
                                   {{0, 10, 0}, {1, 1, 1}}};  // at the eye: H = N
  f.build.surface(1).first.exponent = 0;                      // pow(x,0) = 1 wherever N.L > 0
  expect_colour(f.colour(f.floor), {0.05 + 0.9 + 0.6, 0.08 + 0.5 + 0.6, 0.09 + 0.2 + 0.6});
}

TEST(Shade, LightOnASurfaceIsNotHiddenByIt) {
  Floor f;
  const auto lamp = f.build.cube({-1, 4, -1}, {1, 5, 1}, 2);
  f.build.scene.lighting.lights = {{{0.5, 4, 0.5}, {1, 1, 1}}};  // on the lamp's lower face
  const Scene scene = f.build.finish(f.build.combine(Operation::union_of, f.floor, lamp));
  const Model<double> model(scene, {});
  Classifier<double> classifier(model.solid);
  const RayCena<double> ray{{{2, 3, 0}}, {{0, -1, 0}}};
  classifier.begin(ray);
  Boundary<double> boundary;
  ASSERT_TRUE(classifier.next(boundary));
  RayCounts counts;
  const auto lit = shade(model, classifier, hit_at(model, ray, boundary), counts);
  EXPECT_GT(lit.r, 0.3);
}

TEST(Shade, PointOnTheContinuationOfASurfaceIsStillShadowed) {
  // The point lies on the quadric of a lying cylinder, but beyond its cap, or
  // of an upright cone, but below its base: the ray enters by cap or base.
  for (const bool cylinder : {true, false}) {
    Floor f;
    Placement lying;
    lying.linear = glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, 1, 0});  // the axis along z
    lying.translation = {0, 1, 0};
    const auto solid =
        cylinder ? f.build.primitive(PrimitiveKind::cylinder, lying, 2)
                 : f.build.primitive(PrimitiveKind::cone, test::placed({1, 1, 1}, {0, 1, 0}), 2);
    const Scene scene = f.build.finish(f.build.combine(Operation::union_of, f.floor, solid));
    const Model<double> model(scene, {});
    Classifier<double> classifier(model.solid);
    const RayCena<double> ray{{{0, 10, cylinder ? 3.0 : 2.0}}, {{0, -1, 0}}};
    classifier.begin(ray);
    Boundary<double> boundary;
    ASSERT_TRUE(classifier.next(boundary));
    const auto hit = hit_at(model, ray, boundary);
    const VectorCena<double> to_light{cylinder ? glm::dvec3(0, 4, -4.5) : glm::dvec3(0, 2.6, -3)};
    for (const double clearance : {0.0, 0.1}) {
      const PointLight<double> light{hit.point + to_light, Colour<double>(1), clearance};
      EXPECT_EQ(light_reaching(model, classifier, hit, to_light, light), Colour<double>(0));
    }
  }
}

TEST(Shade, ChequerTakesTheCellOfThePoint) {
  SceneBuilder build;
  const auto floor = build.cube({0, -1, 0}, {4, 0, 4});
  Surface& surface = build.surface(1);
  surface.texture = TextureKind::chequer;
  surface.cells_u = 4;
  surface.cells_v = 2;
  surface.first.ambient = {1, 0, 0};
  surface.second.ambient = {0, 1, 0};
  build.scene.lighting.ambient = glm::dvec3(1);
  Scene scene = build.finish(floor);
  scene.camera = {{4, 4}, {2, 0, 2}, {0, -1, 0}, 5, {0, 0, -1}, true, 5, false};
  RenderOptions options;
  options.size = {4, 4};
  const Planes planes = render(scene, options).planes;
  // From above with z down the picture: u = x/4 in 4 cells, v = z/4 in 2.
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(planes.at(j * 4 + i), ((i + j / 2) % 2 ? Rgb8{0, 255, 0} : Rgb8{255, 0, 0}))
          << i << " " << j;
  options.trace.allowed_effects.texture = false;
  EXPECT_EQ(render(scene, options).planes.at(1), (Rgb8{255, 0, 0}));
}

TEST(Shade, BytesAreRounded) {
  EXPECT_EQ(to_byte(0.0), 0);
  EXPECT_EQ(to_byte(1.0), 255);
  EXPECT_EQ(to_byte(7.0), 255);
  EXPECT_EQ(to_byte(-1.0), 0);
  EXPECT_EQ(to_byte(0.5), 128);  // 127.5 + 0.5
  EXPECT_EQ(to_byte(0.4 / 255), 0);
  EXPECT_EQ(to_byte(0.6 / 255), 1);
  EXPECT_EQ(to_byte(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(to_byte(std::numeric_limits<double>::infinity()), 255);
}

}  // namespace
}  // namespace sir
