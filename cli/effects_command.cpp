#include "cli/effects_command.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "tracer/effect_survey.h"
#include "tracer/scene_file.h"

namespace sir::cli {
namespace {

std::uint64_t all_rays(const RayCounts& counts) {
  return counts.primary + counts.reflected + counts.refracted + counts.shadow;
}

// Why an effect is not called for.
std::string reason_against(const EffectCost& effect, const EffectsCommand& command) {
  EffectSet allowed = command.options.trace.allowed_effects;
  if (effect.name == "antialias" && command.options.antialias.mode == Antialias::none)
    return "not asked for (--antialias)";
  if (!*allowed.find(effect.name)) return "forbidden by --effects";
  if (effect.cause.any()) return "--depth 1 leaves no room for it";
  if (effect.name == "highlight") return "no surface with ks > 0 in any light";
  if (effect.name == "shadow") return "no surface that a light brightens";
  if (effect.name == "filter") return "no surface with kt > 0 in any light";
  if (effect.name == "reflection") return "no surface with ks > 0";
  if (effect.name == "refraction") return "no surface with kt > 0";
  if (effect.name == "texture") return "no chequer of two different sets of coefficients";
  return "no surface has any";
}

std::string light_names(const std::vector<std::size_t>& lights) {
  std::string text;
  for (const std::size_t light : lights)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", light + 1);
  return (lights.size() == 1 ? "light " : "lights ") + text;
}

// The first few nodes by number and name; the lights by their places in the file.
std::string cause_text(const EffectCause& cause, const Scene& scene) {
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, cause.nodes.size()); ++i) {
    const CsgNode& node = scene.tree.nodes[cause.nodes[i]];
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", node.number, node.name);
  }
  if (!text.empty()) text = (cause.nodes.size() == 1 ? "node " : "nodes ") + text;
  if (cause.nodes.size() > kNamed) text += fmt::format(" and {} more", cause.nodes.size() - kNamed);
  if (!cause.lights.empty()) text += (text.empty() ? "" : "; ") + light_names(cause.lights);
  return text.empty() ? "--antialias" : text;
}

std::string as_text(const EffectSurvey& survey, const Scene& scene, const EffectsCommand& command) {
  std::string text = fmt::format("{}: {} rays, {:.0f} ms of processor time\n\n",
                                 command.base.string(), all_rays(survey.counts), survey.ms);
  text += fmt::format("{:<11}{:>6}{:>11}{:>11}  {:<18}{:>17}  {}\n", "effect", "called", "rays",
                      "saves", "time", "pixels", "by, or why not");
  for (const EffectCost& effect : survey.effects) {
    if (!effect.called_for) {
      text += fmt::format("{:<11}{:>6}{:>11}{:>11}  {:<18}{:>17}  {}\n", effect.name, "no", 0, 0,
                          "", "", reason_against(effect, command));
      continue;
    }
    std::string time = fmt::format("{:.1f} %", effect.share * 100);
    if (command.repeats >= 3)
      time += fmt::format(" ({:.1f}..{:.1f})", effect.share_low * 100, effect.share_high * 100);
    const double part = 100.0 * static_cast<double>(effect.pixels) /
                        static_cast<double>(std::max<std::size_t>(1, survey.pixels));
    text +=
        fmt::format("{:<11}{:>6}{:>11}{:>11}  {:<18}{:>17}  {}\n", effect.name, "yes", effect.rays,
                    effect.rays_saved, time, fmt::format("{} ({:.1f} %)", effect.pixels, part),
                    cause_text(effect.cause, scene));
  }
  text += fmt::format(
      "\nrays: cast for the effect itself. saves: rays of any kind that are not cast without it.\n"
      "time: what forbidding it saves of the time of tracing, median{} of {} {}.\n"
      "pixels: those that look otherwise without it.\n",
      command.repeats >= 3 ? " and quartiles" : "", command.repeats,
      command.repeats == 1 ? "pair of runs" : "pairs of runs");
  text +=
      fmt::format("{} rays were spared: they could not change a byte of their pixel any more.\n",
                  survey.counts.spared);
  text += fmt::format(
      "With every effect's rays cast (--effects all): {} rays, {:.2f} times the time, {}.\n",
      all_rays(survey.all_counts), survey.all_ratio,
      survey.all_equal ? "the same image" : "ANOTHER IMAGE");
  return text;
}

std::string as_json(const EffectSurvey& survey, const Scene& scene, const EffectsCommand& command) {
  auto effects = nlohmann::ordered_json::array();
  for (const EffectCost& effect : survey.effects) {
    auto nodes = nlohmann::ordered_json::array(), lights = nlohmann::ordered_json::array();
    for (const std::size_t node : effect.cause.nodes)
      nodes.push_back(scene.tree.nodes[node].number);
    for (const std::size_t light : effect.cause.lights) lights.push_back(light + 1);
    nlohmann::ordered_json json{{"effect", effect.name}, {"called_for", effect.called_for}};
    if (effect.called_for) {
      json["rays"] = effect.rays;
      json["rays_saved"] = effect.rays_saved;
      json["time_share"] = effect.share;
      json["time_share_quartiles"] = {effect.share_low, effect.share_high};
      json["pixels"] = effect.pixels;
    } else {
      json["reason"] = reason_against(effect, command);
    }
    json["nodes"] = nodes;
    json["lights"] = lights;
    effects.push_back(json);
  }
  const RayCounts& rays = survey.counts;
  return nlohmann::ordered_json{{"scene", command.base.string()},
                                {"pixels", survey.pixels},
                                {"ms", survey.ms},
                                {"rays", all_rays(rays)},
                                {"spared", rays.spared},
                                {"effects", effects},
                                {"all",
                                 {{"rays", all_rays(survey.all_counts)},
                                  {"time_ratio", survey.all_ratio},
                                  {"same_image", survey.all_equal}}}}
             .dump(2) +
         "\n";
}

}  // namespace

int run_effects(const EffectsCommand& command, const Session& session) {
  const Scene scene = read_scene(command.base);
  Progress progress(session, command.base.filename().string());
  const EffectSurvey survey =
      survey_effects(scene, command.options, command.repeats, progress.callback(), interruption());
  progress.finish();
  if (!survey.complete) return kInterrupted;
  print(command.json ? as_json(survey, scene, command) : as_text(survey, scene, command));
  return kDone;
}

}  // namespace sir::cli
