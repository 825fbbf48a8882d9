// The same from the four files themselves, one after the other: CSG, CAM, LUZ, SUP, separated by
// lines that are a percent sign alone.
#include <algorithm>
#include <array>
#include <string_view>

#include "fuzz/engines.h"
#include "fuzz/refusal.h"
#include "fuzz/shown.h"
#include "fuzz/targets.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {
namespace {

constexpr std::size_t kMostNodes = 64;  // so many take milliseconds by the plain engine
constexpr std::size_t kMostLights = 4;

std::array<std::string_view, 4> four_of(std::string_view text) {
  constexpr std::string_view kMark = "\n%\n";
  std::array<std::string_view, 4> parts{};
  for (std::string_view& part : parts) {
    const auto end = std::min(text.find(kMark), text.size());
    part = text.substr(0, end);
    text.remove_prefix(std::min(end + kMark.size(), text.size()));
  }
  return parts;
}

}  // namespace

void play_pipeline_text(Bytes bytes) {
  const auto [csg, camera, light, surfaces] = four_of(text_of(bytes));
  Scene scene;
  const bool accepted =
      accepts("F.CSG", csg, [&](TextFile& file) { scene.tree = read_csg(file); }) &&
      accepts("F.CAM", camera, [&](TextFile& file) { scene.camera = read_camera(file); }) &&
      accepts("F.LUZ", light, [&](TextFile& file) { scene.lighting = read_lighting(file); }) &&
      accepts("F.SUP", surfaces, [&](TextFile& file) { scene.surfaces = read_surfaces(file); }) &&
      accepts("F.CSG", csg,
              [&](TextFile&) { check_surfaces(scene.tree, scene.surfaces, "F.CSG", "F.SUP"); });
  if (!accepted || scene.tree.nodes.size() > kMostNodes ||
      scene.lighting.lights.size() > kMostLights)
    return;
  RenderOptions options;
  options.size = {5, 4};
  show_by_method(image_by_all_engines(scene, options),
                 static_cast<int>(bytes.size() % kShownOnceIn));
  options.precision = Precision::float_;
  image_by_all_engines(scene, options);
}

}  // namespace sir::fuzz
