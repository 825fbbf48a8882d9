#include "cli/render_settings.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>
#include <sstream>

#include "build_facts.h"
#include "cli/option_values.h"
#include "tracer/fnv1a.h"
#include "tracer/scene_file.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

std::uint64_t number_for(std::string_view text) {
  return fnv1a(std::as_bytes(std::span(text.data(), text.size())));
}

// Programs of one version need not trace the same bytes while the version is being worked on.
std::string program() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::array<char, 1 << 16> part;
  std::uint64_t number = number_for({});
  while (file.read(part.data(), part.size()), file.gcount() > 0)
    number = fnv1a(std::as_bytes(std::span(part.data(), static_cast<std::size_t>(file.gcount()))),
                   number);
  return fmt::format("{} {:016x}", kVersion, number);
}

std::string effects_text(EffectSet effects) {
  std::string text;
  for (const std::string& name : EffectSet::names())
    if (*effects.find(name)) text += (text.empty() ? "" : ",") + name;
  if (effects.exhaustive) text += " all";
  return text.empty() ? "none" : text;
}

std::string antialias_text(const RenderOptions& options) {
  const AntialiasOptions& antialias = options.antialias;
  if (!options.antialiased()) return "none";
  if (antialias.mode == Antialias::adaptive)
    return fmt::format("adaptive:{}:{}", antialias.threshold, antialias.levels);
  return fmt::format("random:{}:{}", antialias.samples, antialias.seed);
}

const char* engine_name(Engine engine) {
  switch (engine) {
    case Engine::gates: return "gates";
    case Engine::roth: return "roth";
    case Engine::envelopes: return "envelopes";
  }
  return "?";
}

std::map<std::string, std::string> by_name(const std::string& settings) {
  std::map<std::string, std::string> lines;
  std::istringstream text(settings);
  for (std::string line; std::getline(text, line);) {
    const std::size_t space = std::min(line.find(' '), line.size());
    lines[line.substr(0, space)] = line.substr(std::min(space + 1, line.size()));
  }
  return lines;
}

}  // namespace

std::string render_settings(const Scene& scene, const RenderOptions& options, bool progressive) {
  const TraceOptions& trace = options.trace;
  const Region region = region_or_all(options.region, options.size);
  return fmt::format(
      "program {}\n.CSG {:016x}\n.CAM {:016x}\n.LUZ {:016x}\n.SUP {:016x}\n"
      "--size {}x{}\n--region {},{},{},{}\n--precision {}\n--depth {}\n--cutoff {}\n"
      "--past-limit {}\n--effects {}\n--engine {}\n--formulas {}\n--antialias {}\n"
      "--progressive {}\n",
      program(), number_for(csg_text(scene.tree)), number_for(camera_text(scene.camera)),
      number_for(lighting_text(scene.lighting)), number_for(surfaces_text(scene.surfaces)),
      options.size.width, options.size.height, region.x, region.y, region.width, region.height,
      name_of(options.precision), trace.depth_limit, trace.cutoff,
      trace.past_limit == PastLimit::zero ? "zero" : "background",
      effects_text(trace.allowed_effects), engine_name(trace.engine),
      trace.formulas == Formulas::robust ? "robust" : "textbook", antialias_text(options),
      progressive ? "given" : "not given");
}

std::string settings_difference(const std::string& now, const std::string& before) {
  const auto ours = by_name(now), theirs = by_name(before);
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const auto& [name, value] : ours) {
    const auto other = theirs.find(name);
    if (other == theirs.end()) add(name + " was not known");
    else if (other->second == value) continue;
    else if (name == "program") add("the program is another");
    else if (name.starts_with('.')) add("the scene's " + name + " is another");
    else add(fmt::format("{} is {} and was {}", name, value, visible(other->second)));
  }
  for (const auto& [name, value] : theirs)
    if (!ours.contains(name)) add(visible(name) + " is not known");
  return text;
}

}  // namespace sir::cli
