#include "cli/render_command.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/hesitation_report.h"
#include "cli/interrupt.h"
#include "cli/option_values.h"
#include "cli/output_path.h"
#include "cli/progress.h"
#include "cli/render_keeping.h"
#include "tracer/atomic_files.h"
#include "tracer/error.h"
#include "tracer/sample_progressive.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"

namespace sir::cli {
namespace {

nlohmann::ordered_json costs_json(const CostCounts& costs) {
  return {{"calls", costs.calls},
          {"combinations", costs.combinations},
          {"transformations", costs.transformations()},
          {"intersection_tests", costs.intersection_tests()},
          {"envelopes", costs.envelopes}};
}

nlohmann::ordered_json stats_json(const RenderCommand& command, const Scene& scene,
                                  const RenderResult& result) {
  nlohmann::ordered_json effects = nlohmann::ordered_json::object();
  EffectSet ran = result.effects;
  for (const std::string& name : EffectSet::names()) effects[name] = *ran.find(name);
  std::size_t primitives = 0;
  for (const CsgNode& node : scene.tree.nodes) primitives += !node.composite;
  const RayCounts& rays = result.counts;
  return {
      {"width", result.planes.size.width},
      {"height", result.planes.size.height},
      {"precision", name_of(command.options.precision)},
      {"formulas", command.options.trace.formulas == Formulas::robust ? "robust" : "textbook"},
      {"nodes", scene.tree.nodes.size()},
      {"primitives", primitives},
      {"lights", scene.lighting.lights.size()},
      {"rays",
       {{"primary", rays.primary},
        {"reflected", rays.reflected},
        {"refracted", rays.refracted},
        {"shadow", rays.shadow},
        {"filtered", rays.filtered},
        {"spared", rays.spared}}},
      {"spans", rays.spans},
      {"exact_intersections", rays.exact},
      {"packets", rays.packets},
      {"doubtful", rays.doubtful},
      {"costs", costs_json(rays.costs)},
      {"effects", effects},
      {"ms", {{"prepare", result.prepare_seconds * 1e3}, {"trace", result.trace_seconds * 1e3}}}};
}

nlohmann::ordered_json antialias_json(const AntialiasOptions& options,
                                      const AntialiasCounts& counts) {
  if (options.mode == Antialias::adaptive)
    return {{"mode", "adaptive"},
            {"threshold", options.threshold},
            {"levels", options.levels},
            {"points", counts.points},
            {"divided", counts.divided}};
  return {{"mode", "random"},
          {"samples", options.samples},
          {"seed", options.seed},
          {"points", counts.points}};
}

// The picture so far goes to BASE.png; what was shown is left in `stages`.
RenderResult render_in_stages(const RenderOptions& options, const Scene& scene,
                              const std::filesystem::path& base, const Session& session,
                              Progress& progress, nlohmann::ordered_json& stages) {
  stages = nlohmann::ordered_json::array();
  double written = 0;
  const auto show = [&](const Planes& picture, const Stage& stage) {
    // A stage that traced nothing shows nothing new.
    if (stage.share > written || stage.antialiased)
      viewer::write_rgb_png(with_suffix(base, "png"), picture);
    written = stage.share;
    progress.finish();  // the line, until there is more to say
    detail(session,
           fmt::format("{}: {}, {:.1f} % of the pixels traced", base.string(),
                       stage.antialiased    ? "antialiased"
                       : stage.refined_only ? fmt::format("refined to {0}x{0}", stage.block)
                                            : fmt::format("all of {0}x{0}", stage.block),
                       stage.share * 100));
    stages.push_back({{"block", stage.block},
                      {"refined_only", stage.refined_only},
                      {"antialiased", stage.antialiased},
                      {"share", stage.share}});
  };
  return render_progressive(scene, options, show, interruption(), progress.callback());
}

// Links may lead from an output to one of the four files.
void refuse_inputs(const std::filesystem::path& base, const RenderCommand& command) {
  for (const char* output : {"R", "G", "B", "png", "tiles"})
    for (const char* input : {"CSG", "CAM", "LUZ", "SUP"}) {
      const auto file = find_by_suffix(command.base, input);
      refuse_same_file(with_suffix(base, output), file);
      if (command.hesitation) refuse_same_file(*command.hesitation, file);
    }
}

// Hours of rendering must not end where there is no permission to write.
void require_outputs(const std::filesystem::path& base, const RenderCommand& command) {
  for (int channel = 0; channel < 3; ++channel) require_writable(plane_path(base, channel));
  if (command.png) require_writable(with_suffix(base, "png"));
  if (command.hesitation) require_writable(*command.hesitation);
}

void refuse_outputs(const std::filesystem::path& path, const std::filesystem::path& base) {
  require_picture_name(path);
  for (const char* output : {"R", "G", "B", "png", "tiles"})
    if (same_place(path, with_suffix(base, output)))
      throw FileError(path.string(), 0,
                      "is a file of the image itself; the marked image needs another name");
}

// All of them together; their names.
std::string write_outputs(const RenderCommand& command, const std::filesystem::path& base,
                          const Planes& planes, const HesitationMap& hesitation) {
  AtomicFiles together;
  write_planes(together, base, planes);
  std::string written = fmt::format("{0}.R {0}.G {0}.B", base.string());
  if (command.png) {
    const auto png = with_suffix(base, "png");
    if (!command.progressive) viewer::write_rgb_png(together.add(png), planes);  // else it is there
    written += " " + png.string();
  }
  if (command.hesitation) {
    viewer::write_rgb_png(together.add(*command.hesitation), marked(planes, hesitation));
    written += " " + command.hesitation->string();
  }
  together.commit();
  return written;
}

}  // namespace

int run_render(const RenderCommand& command, const Session& session) {
  const Scene scene = read_scene(command.base);
  const auto base = output_base(command.base, command.out);
  refuse_inputs(base, command);
  if (command.hesitation) refuse_outputs(*command.hesitation, base);
  require_outputs(base, command);
  Progress progress(session, command.base.filename().string());
  if (command.options.antialias.mode != Antialias::none && !command.options.antialiased())
    note(session, "not antialiased: --effects does not allow it");
  RenderKeeping keeping(command, scene, base, session);
  keeping.begin();
  progress.take_over([&] { return keeping.record().taken_share(); });
  RenderOptions options = command.options;
  options.keeper = &keeping.record();
  nlohmann::ordered_json stages;
  const RenderResult result =
      command.progressive ? render_in_stages(options, scene, base, session, progress, stages)
                          : render(scene, options, progress.callback(), interruption());
  progress.finish();
  keeping.say_tiles();
  if (!result.complete) {
    keeping.say_how_to_continue();
    if (!stages.empty())
      note(session, with_suffix(base, "png").string() +
                        " holds the picture as far as it came; the planes are as they were");
    return kInterrupted;
  }
  HesitationMap hesitation;
  if (command.hesitation) {
    Progress comparing(session, command.base.filename().string() + ", hesitation");
    hesitation = find_hesitation(scene, command.options, comparing.callback(), interruption());
    comparing.finish();
    if (!hesitation.complete) {
      keeping.say_how_to_continue();
      return kInterrupted;
    }
  }

  std::string written;
  try {
    written = write_outputs(command, base, result.planes, hesitation);
  } catch (const FileError&) {
    keeping.say_how_to_continue();
    throw;
  }
  keeping.record().remove();
  const auto& rays = result.counts;
  detail(session, fmt::format("{}: {}x{}, {} rays in {:.0f} ms", base.string(),
                              result.planes.size.width, result.planes.size.height,
                              rays.primary + rays.reflected + rays.refracted + rays.shadow,
                              result.trace_seconds * 1e3));
  note(session, "wrote " + written);
  if (command.stats) {
    auto json = stats_json(command, scene, result);
    if (command.options.antialiased())
      json["antialias"] = antialias_json(command.options.antialias, result.antialias);
    if (command.progressive) json["stages"] = stages;
    if (command.hesitation) json["hesitation"] = hesitation_json(scene, hesitation);
    print(json.dump() + "\n");
  } else if (command.hesitation) {
    print(hesitation_table(scene, hesitation));
  }
  return kDone;
}

}  // namespace sir::cli
