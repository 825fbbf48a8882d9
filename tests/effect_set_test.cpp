#include "tracer/effect_set.h"

#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/render.h"

namespace sir {
namespace {

using test::SceneBuilder;

std::string called_for(const Scene& scene, const EffectSet& allowed = {}) {
  EffectSet set = effects_called_for(scene, allowed);
  std::string text;
  for (const std::string& name : EffectSet::names())
    if (*set.find(name)) text += name + " ";
  return text;
}

TEST(EffectSet, MatteSceneCallsForShadowsOnly) {
  SceneBuilder build;
  build.scene.lighting.lights = {{{0, 9, 0}, glm::dvec3(1)}};
  build.surface(9).first = {glm::dvec3(1), glm::dvec3(1), 1, 1, 1, 1.5};  // reached by no node
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 1));
  EXPECT_EQ(called_for(scene), "shadow ");
}

TEST(EffectSet, EachEffectIsCalledForByWhatNeedsIt) {
  SceneBuilder build;
  build.surface(1).first.specular = 0.1;
  EXPECT_EQ(called_for(build.finish(build.sphere({0, 0, 0}, 1))), "reflection ");
  build.scene.lighting.lights = {{{0, 9, 0}, glm::dvec3(1)}};
  EXPECT_EQ(called_for(build.finish(0)), "highlight shadow reflection ");
  build.surface(1).texture = TextureKind::chequer;
  build.surface(1).second.transmission = 0.5;
  EXPECT_EQ(called_for(build.finish(0)), "highlight shadow filter reflection refraction texture ");
  EffectSet allowed;
  allowed.reflection = allowed.texture = false;
  EXPECT_EQ(called_for(build.finish(0), allowed), "highlight shadow filter refraction ");
}

TEST(EffectSet, AntialiasingIsOnWhereItIsWantedAndAllowed) {
  SceneBuilder build;
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 1));
  EffectSet allowed;
  for (const bool all : {false, true}) {
    allowed.exhaustive = all;
    allowed.antialias = true;
    EXPECT_TRUE(effects_called_for(scene, allowed, true).antialias);
    EXPECT_FALSE(effects_called_for(scene, allowed).antialias);
    allowed.antialias = false;
    EXPECT_FALSE(effects_called_for(scene, allowed, true).antialias);
  }
}

TEST(EffectSet, UnknownNamesAreNotFound) {
  EffectSet set;
  EXPECT_EQ(set.find("Shadow"), nullptr);
  EXPECT_EQ(set.find(""), nullptr);
  EXPECT_EQ(set.find("bump"), &set.bump);
}

TEST(EffectSet, AutoEqualsAllByteForByte) {
  RenderOptions options;
  options.size = {48, 36};
  options.trace.depth_limit = 4;
  std::uint64_t saved = 0;
  for (std::uint64_t seed = 0; seed < test::cases(40); ++seed) {
    const Scene scene = test::random_scene(seed, 2 + static_cast<int>(seed) % 8, seed % 4 == 0);
    options.trace.allowed_effects.exhaustive = false;
    const auto needed = render(scene, options);
    options.trace.allowed_effects.exhaustive = true;
    const auto all = render(scene, options);
    ASSERT_EQ(needed.planes, all.planes) << seed;
    saved += all.counts.shadow - needed.counts.shadow;
    saved += all.counts.reflected - needed.counts.reflected;
  }
  EXPECT_GT(saved, 10000u);
}

}  // namespace
}  // namespace sir
