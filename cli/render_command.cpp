#include "cli/render_command.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/output_path.h"
#include "cli/progress.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"

namespace sir::cli {
namespace {

std::string stats_json(const RenderCommand& command, const Scene& scene,
                       const RenderResult& result) {
  nlohmann::ordered_json effects = nlohmann::ordered_json::object();
  EffectSet ran = result.effects;
  for (const std::string& name : EffectSet::names()) effects[name] = *ran.find(name);
  std::size_t primitives = 0;
  for (const CsgNode& node : scene.tree.nodes) primitives += !node.composite;
  const RayCounts& rays = result.counts;
  const nlohmann::ordered_json json{
      {"width", result.planes.size.width},
      {"height", result.planes.size.height},
      {"precision", command.options.precision == Precision::float_ ? "float" : "double"},
      {"nodes", scene.tree.nodes.size()},
      {"primitives", primitives},
      {"lights", scene.lighting.lights.size()},
      {"rays",
       {{"primary", rays.primary},
        {"reflected", rays.reflected},
        {"refracted", rays.refracted},
        {"shadow", rays.shadow}}},
      {"spans", rays.spans},
      {"exact_intersections", rays.exact},
      {"effects", effects},
      {"ms", {{"prepare", result.prepare_seconds * 1e3}, {"trace", result.trace_seconds * 1e3}}}};
  return json.dump() + "\n";
}

// Links may lead from an output to one of the four files.
void refuse_inputs(const std::filesystem::path& base, const RenderCommand& command) {
  for (const char* output : {"R", "G", "B", "png"})
    for (const char* input : {"CSG", "CAM", "LUZ", "SUP"})
      refuse_same_file(with_suffix(base, output), find_by_suffix(command.base, input));
}

}  // namespace

int run_render(const RenderCommand& command, const Session& session) {
  const Scene scene = read_scene(command.base);
  const auto base = output_base(command.base, command.out);
  refuse_inputs(base, command);
  Progress progress(session, command.base.filename().string());
  const RenderResult result = render(scene, command.options, progress.callback(), interruption());
  progress.finish();
  if (!result.complete) return kInterrupted;

  write_planes(base, result.planes);
  std::string written = fmt::format("{0}.R {0}.G {0}.B", base.string());
  if (command.png) {
    const auto png = with_suffix(base, "png");
    viewer::write_rgb_png(png, result.planes);
    written += " " + png.string();
  }
  const auto& rays = result.counts;
  detail(session, fmt::format("{}: {}x{}, {} rays in {:.0f} ms", base.string(),
                              result.planes.size.width, result.planes.size.height,
                              rays.primary + rays.reflected + rays.refracted + rays.shadow,
                              result.trace_seconds * 1e3));
  note(session, "wrote " + written);
  if (command.stats) print(stats_json(command, scene, result));
  return kDone;
}

}  // namespace sir::cli
