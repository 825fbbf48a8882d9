// All of SIR: a scene, its files, its image by every engine, LUTs, the display.
#include <optional>
#include <string>

#include "fuzz/engines.h"
#include "fuzz/made_scene.h"
#include "fuzz/same.h"
#include "fuzz/shown.h"
#include "fuzz/targets.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {
namespace {

// The scene as it comes out of its files; none where a reader refuses it, as it may for a singular
// matrix or for numbers that no camera can have.
std::optional<Scene> through_files(const Scene& made) {
  const auto read = [](std::string name, std::string text, const auto& reader) {
    TextFile file(std::move(name), std::move(text));
    return reader(file);
  };
  Scene scene;
  try {
    scene.tree = read("M.CSG", csg_text(made.tree), read_csg);
    scene.camera = read("M.CAM", camera_text(made.camera), read_camera);
    scene.surfaces = read("M.SUP", surfaces_text(made.surfaces), read_surfaces);
  } catch (const FileError&) {
    return std::nullopt;
  }
  scene.lighting = read("M.LUZ", lighting_text(made.lighting), read_lighting);
  require(same(scene.tree, made.tree) && same(scene.camera, made.camera) &&
              same(scene.lighting, made.lighting) && same(scene.surfaces, made.surfaces),
          "a scene that is written reads as what it was");
  check_surfaces(scene.tree, scene.surfaces, "M.CSG", "M.SUP");
  return scene;
}

RenderOptions options_of(ByteSource& source) {
  RenderOptions options;
  options.size = {1 + source.below(8), 1 + source.below(8)};
  constexpr Precision kPrecisions[] = {Precision::double_, Precision::double_, Precision::float_,
                                       Precision::long_double};
  options.precision = kPrecisions[source.below(4)];
  options.trace.depth_limit = 1 + source.below(5);
  options.trace.cutoff = source.flag() ? source.share() / 4 : 0;
  options.trace.past_limit = source.flag() ? PastLimit::background : PastLimit::zero;
  // Mostly all of them; exhaustive seldom, for it costs most.
  EffectSet& effects = options.trace.allowed_effects;
  const std::uint8_t off = source.byte();
  if (off >= 192)
    for (int bit = 0; const std::string& name : EffectSet::names())
      if ((off >> bit++ % 6 & 1) != 0) *effects.find(name) = false;
  effects.exhaustive = off % 16 == 15;
  return options;
}

}  // namespace

void play_pipeline(Bytes bytes) {
  ByteSource source(bytes);
  const RenderOptions options = options_of(source);
  const int method = source.below(kShownOnceIn);
  const auto scene = through_files(made_scene(source));
  if (scene) show_by_method(image_by_all_engines(*scene, options), method);
}

}  // namespace sir::fuzz
