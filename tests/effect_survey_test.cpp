// What calls for an effect, and what forbidding it saves and changes.
#include "tracer/effect_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene_builder.h"

namespace sir {
namespace {

using test::SceneBuilder;
using testing::ElementsAre;
using testing::IsEmpty;

// A matt floor (node 0), a mirror ball (1), a glass ball (2), joined by 3 and 4;
// node 5, which shines, hangs on nothing.
struct Room {
  Room() {
    build.scene.lighting.background = {0.1, 0.2, 0.4};
    build.scene.lighting.lights = {
        {{2, 9, 1}, glm::dvec3(1)}, {{0, 5, 0}, glm::dvec3(0)}, {{-3, 7, 2}, {0.2, 0, 0}}};
    const auto floor = build.cube({-4, -1, -4}, {4, 0, 4}, 1);
    const auto mirror = build.sphere({-1.5, 1, 0}, 1, 2);
    const auto glass = build.sphere({1.5, 1, 0}, 1, 3);
    build.surface(1).first.diffuse = glm::dvec3(0.7);
    build.surface(2).first.specular = 0.6;
    build.surface(2).first.exponent = 20;
    build.surface(3).first.transmission = 0.7;
    build.surface(3).first.index = 1.4;
    build.surface(3).first.diffuse = glm::dvec3(0.1);
    root = build.combine(Operation::union_of, build.combine(Operation::union_of, floor, mirror),
                         glass);
    build.sphere({0, 3, 0}, 0.5, 2);
    options.size = {64, 48};
  }
  Scene scene() {
    Scene made = build.finish(root);
    made.camera = {{4, 3}, {0, 1, 0}, {0, -0.3, -1}, 6, {0, 1, 0}, false, 6, false};
    return made;
  }
  const EffectCost& of(const EffectSurvey& survey, const std::string& name) {
    for (const EffectCost& effect : survey.effects)
      if (effect.name == name) return effect;
    throw std::out_of_range(name);
  }
  SceneBuilder build;
  std::size_t root;
  RenderOptions options;
};

TEST(EffectCauses, NameNodesAndLights) {
  Room room;
  const EffectCauses causes = effect_causes(room.scene());
  EXPECT_THAT(causes.reflection.nodes, ElementsAre(1));
  EXPECT_THAT(causes.reflection.lights, IsEmpty());
  EXPECT_THAT(causes.refraction.nodes, ElementsAre(2));
  EXPECT_THAT(causes.highlight.nodes, ElementsAre(1));
  EXPECT_THAT(causes.highlight.lights, ElementsAre(0, 2)) << "the second light is out";
  EXPECT_THAT(causes.shadow.nodes, ElementsAre(0, 1, 2));
  EXPECT_THAT(causes.filter.nodes, ElementsAre(2));
  EXPECT_THAT(causes.texture.nodes, IsEmpty());
}

TEST(EffectCauses, NothingShinesWithoutLight) {
  Room room;
  room.build.scene.lighting.lights = {{{0, 5, 0}, glm::dvec3(0)}};
  const EffectCauses causes = effect_causes(room.scene());
  for (const EffectCause& cause : {causes.highlight, causes.shadow, causes.filter})
    EXPECT_FALSE(cause.any());
  EXPECT_TRUE(causes.reflection.any());
}

TEST(EffectCauses, SurfacesThatNoLightBrightensCallForNoShadow) {
  SceneBuilder build;
  build.scene.lighting.lights = {{{0, 9, 0}, glm::dvec3(1)}};
  build.surface(1).first = {};
  build.surface(1).first.ambient = glm::dvec3(1);
  const Scene scene = build.finish(build.sphere({0, 0, 0}, 1));
  EXPECT_FALSE(effects_called_for(scene, {}).shadow);
  RenderOptions options;
  options.size = {32, 24};
  EXPECT_EQ(render(scene, options).counts.shadow, 0u);
}

TEST(EffectCauses, AChequerOfEqualCellsIsNoTexture) {
  SceneBuilder build;
  build.surface(1).texture = TextureKind::chequer;
  build.surface(1).second = build.surface(1).first;
  Scene scene = build.finish(build.sphere({0, 0, 0}, 1));
  EXPECT_FALSE(effects_called_for(scene, {}).texture);
  scene.surfaces[0].second.exponent += 1;
  EXPECT_TRUE(effects_called_for(scene, {}).texture);
}

TEST(EffectCauses, TheDepthLimitLeavesNoRoom) {
  TraceOptions options;
  EXPECT_TRUE(options.possible_effects().reflection);
  options.depth_limit = 1;
  EXPECT_FALSE(options.possible_effects().reflection);
  EXPECT_FALSE(options.possible_effects().refraction);
  options.past_limit = PastLimit::background;
  EXPECT_TRUE(options.possible_effects().refraction);
}

TEST(EffectSurvey, AnEffectThatIsNotCalledForCastsNoRay) {
  Room room;
  room.build.surface(2).first.specular = 0;
  const RayCounts no_mirror = render(room.scene(), room.options).counts;
  EXPECT_EQ(no_mirror.reflected, 0u) << "total reflection needs a denser inside";
  EXPECT_GT(no_mirror.refracted, 0u);
  room.build.surface(3).first.transmission = 0;
  const RayCounts matt = render(room.scene(), room.options).counts;
  EXPECT_EQ(matt.reflected + matt.refracted + matt.filtered, 0u);
  EXPECT_GT(matt.shadow, 0u);
  room.build.scene.lighting.lights.clear();
  EXPECT_EQ(render(room.scene(), room.options).counts.shadow, 0u);
}

TEST(EffectSurvey, SaysWhatEachEffectCastsAndChanges) {
  Room room;
  const EffectSurvey survey = survey_effects(room.scene(), room.options, 2);
  ASSERT_TRUE(survey.complete);
  EXPECT_TRUE(survey.all_equal);
  EXPECT_GT(survey.all_counts.shadow, survey.counts.shadow);
  ASSERT_EQ(survey.effects.size(), EffectSet::names().size());
  const Planes usual = render(room.scene(), room.options).planes;
  for (const EffectCost& effect : survey.effects) {
    SCOPED_TRACE(effect.name);
    const bool none =
        effect.name == "texture" || effect.name == "bump" || effect.name == "antialias";
    EXPECT_EQ(effect.called_for, !none);
    if (none) {
      EXPECT_EQ(effect.rays + effect.rays_saved + effect.pixels, 0u);
      continue;
    }
    EXPECT_GT(effect.pixels, 0u);
    RenderOptions without = room.options;
    *without.trace.allowed_effects.find(effect.name) = false;
    const Planes forbidden = render(room.scene(), without).planes;
    std::size_t changed = 0;
    for (std::size_t p = 0; p < usual.size.pixels(); ++p)
      changed += !(usual.at(p) == forbidden.at(p));
    EXPECT_EQ(effect.pixels, changed);
    EXPECT_LE(effect.share_low, effect.share);
    EXPECT_LE(effect.share, effect.share_high);
  }
  EXPECT_EQ(room.of(survey, "shadow").rays, survey.counts.shadow);
  EXPECT_EQ(room.of(survey, "shadow").rays_saved, survey.counts.shadow);
  EXPECT_EQ(room.of(survey, "reflection").rays, survey.counts.reflected);
  EXPECT_GT(room.of(survey, "reflection").rays_saved, survey.counts.reflected);
  EXPECT_EQ(room.of(survey, "filter").rays, survey.counts.filtered);
  EXPECT_EQ(room.of(survey, "highlight").rays, 0u);
}

TEST(EffectSurvey, CountsSamplesBeyondOneAPixel) {
  Room room;
  room.options.antialias.mode = Antialias::random;
  room.options.antialias.samples = 4;
  const EffectSurvey survey = survey_effects(room.scene(), room.options, 1);
  EXPECT_EQ(room.of(survey, "antialias").rays, 3u * 64 * 48);
  EXPECT_GT(room.of(survey, "antialias").pixels, 0u);
}

TEST(EffectSurvey, StopsWhenAsked) {
  Room room;
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(survey_effects(room.scene(), room.options, 1, {}, source.get_token()).complete);
}

}  // namespace
}  // namespace sir
