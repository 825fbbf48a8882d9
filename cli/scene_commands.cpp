#include "cli/scene_commands.h"

#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "tracer/error.h"
#include "tracer/model.h"
#include "tracer/scene_file.h"

namespace sir::cli {
namespace {

std::string listed(const std::map<std::string, std::size_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, name);
  return text.empty() ? "none" : text;
}

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z);
}

}  // namespace

int run_check(const std::filesystem::path& base, const Session& session) {
  const Scene scene = read_scene(base);
  const Model<double> model(scene, {});
  std::map<std::string, std::size_t> primitives, operations;
  std::set<std::int64_t> used;
  for (const CsgNode& node : scene.tree.nodes) {
    constexpr const char* kOperation[] = {"union", "difference", "intersection"};
    constexpr const char* kKind[] = {"cube", "sphere", "cone", "cylinder"};
    if (node.composite) {
      ++operations[kOperation[static_cast<int>(node.operation)]];
      continue;
    }
    ++primitives[kKind[static_cast<int>(node.kind)]];
    used.insert(node.surfaces.begin(), node.surfaces.begin() + face_count(node.kind));
  }
  std::string text = fmt::format("{}: all four files are right\n", base.string());
  text +=
      fmt::format("  solid       {}, {}; {}; {}\n", counted(scene.tree.nodes.size(), "node"),
                  counted(depth_of(scene.tree), "level"), listed(primitives), listed(operations));
  auto bounds = model.solid.hierarchy.bounds();
  // Envelopes are widened by the rounding of a hit: 0 is shown, not -1e-14.
  const double small = 1e-9 * glm::length(bounds.high - bounds.low);
  for (auto* corner : {&bounds.low, &bounds.high})
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs((*corner)[axis]) < small) (*corner)[axis] = 0;
  text += fmt::format("  envelope    {} to {} (of all primitives)\n", vector_text(bounds.low),
                      vector_text(bounds.high));
  text += fmt::format("  surfaces    {} described, {} used\n", scene.surfaces.size(), used.size());
  const CameraFile& camera = scene.camera;
  text +=
      fmt::format("  camera      window {:g} x {:g}, target {}, distance {:g}, {}\n",
                  camera.window.x, camera.window.y, vector_text(camera.target), camera.distance,
                  camera.parallel ? "parallel" : fmt::format("focal distance {:g}", camera.focal));
  text += fmt::format("  light       background {}, ambient {}, {}\n",
                      vector_text(scene.lighting.background), vector_text(scene.lighting.ambient),
                      counted(scene.lighting.lights.size(), "light"));
  EffectSet effects = model.effects;
  std::string called_for;
  for (const std::string& name : EffectSet::names())
    if (*effects.find(name)) called_for += " " + name;
  text += fmt::format("  effects    {}\n", called_for.empty() ? " none" : called_for);
  print(text);
  for (const Surface& surface : scene.surfaces)
    if (!used.contains(surface.number))
      detail(session, fmt::format("surface {} \"{}\" is used by no primitive", surface.number,
                                  surface.name));
  return kDone;
}

int run_trace(const TraceCommand& command, const Session&) {
  const Scene scene = read_scene(command.base);
  const auto traced = trace_pixel(scene, command.options, command.i, command.j);
  print(fmt::format("pixel in column {}, row {} of {}x{}: bytes {} {} {}\n", command.i, command.j,
                    command.options.size.width, command.options.size.height, traced.pixel.r,
                    traced.pixel.g, traced.pixel.b));
  print(describe(traced.log, scene));
  return kDone;
}

}  // namespace sir::cli
