#include "tracer/effect_survey.h"

#include <algorithm>

namespace sir {
namespace {

// One way to render the scene, and what came of it.
struct Way {
  EffectSet allowed;
  std::vector<double> seconds{};  // one for each round
  Planes planes{};
  RayCounts counts{};
};

std::uint64_t all_rays(const RayCounts& counts) {
  return counts.primary + counts.reflected + counts.refracted + counts.shadow;
}

std::uint64_t own_rays(const std::string& effect, const RayCounts& counts, std::size_t pixels) {
  if (effect == "shadow") return counts.shadow;
  if (effect == "filter") return counts.filtered;
  if (effect == "reflection") return counts.reflected;
  if (effect == "refraction") return counts.refracted;
  if (effect == "antialias")
    return counts.primary - std::min<std::uint64_t>(counts.primary, pixels);
  return 0;
}

std::size_t different_pixels(const Planes& a, const Planes& b) {
  std::size_t count = 0;
  for (std::size_t p = 0; p < a.size.pixels(); ++p) count += !(a.at(p) == b.at(p));
  return count;
}

// The value below which `part` of the sorted values lie.
double quantile(const std::vector<double>& sorted, double part) {
  const double at = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::vector<double> sorted_ratios(const Way& numerator, const Way& denominator) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < numerator.seconds.size(); ++round)
    ratios.push_back(numerator.seconds[round] / std::max(denominator.seconds[round], 1e-9));
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

EffectCause cause_of(const std::string& name, const EffectCauses& causes) {
  if (name == "highlight") return causes.highlight;
  if (name == "shadow") return causes.shadow;
  if (name == "filter") return causes.filter;
  if (name == "reflection") return causes.reflection;
  if (name == "refraction") return causes.refraction;
  if (name == "texture") return causes.texture;
  return {};
}

}  // namespace

EffectSurvey survey_effects(const Scene& scene, const RenderOptions& options, int repeats,
                            const std::function<void(double)>& progress, std::stop_token stop) {
  EffectSurvey survey;
  EffectSet allowed = options.trace.allowed_effects;
  allowed.exhaustive = false;
  TraceOptions needed = options.trace;
  needed.allowed_effects = allowed;
  EffectSet called_for =
      effects_called_for(scene, needed.possible_effects(), options.antialiased());

  std::vector<Way> ways{{allowed}, {allowed}};
  ways[1].allowed.exhaustive = true;
  const EffectCauses causes = effect_causes(scene);
  for (const std::string& name : EffectSet::names()) {
    survey.effects.push_back({name, *called_for.find(name), cause_of(name, causes)});
    if (!survey.effects.back().called_for) continue;
    ways.push_back({allowed});
    *ways.back().allowed.find(name) = false;
  }

  // The first round warms up.
  const std::size_t rounds = static_cast<std::size_t>(repeats) + 1;
  const double renders = static_cast<double>(ways.size() * rounds);
  double done = 0;
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < ways.size(); ++n) {
      // Each round begins with another way, so that none is always the first.
      Way& way = ways[(round + n) % ways.size()];
      RenderOptions own = options;
      own.trace.allowed_effects = way.allowed;
      RenderResult result = render(scene, own, {}, stop);
      if (!result.complete) {
        survey.complete = false;
        return survey;
      }
      if (round > 0) way.seconds.push_back(result.processor_seconds);
      way.counts = result.counts;
      way.planes = std::move(result.planes);
      if (progress) progress(++done / renders);
    }

  const Way& usual = ways[0];
  survey.pixels = usual.planes.size.pixels();
  survey.counts = usual.counts;
  survey.all_counts = ways[1].counts;
  survey.all_equal = usual.planes == ways[1].planes;
  survey.all_ratio = quantile(sorted_ratios(ways[1], usual), 0.5);
  std::vector<double> seconds = usual.seconds;
  std::sort(seconds.begin(), seconds.end());
  survey.ms = quantile(seconds, 0.5) * 1e3;
  std::size_t next = 2;
  for (EffectCost& effect : survey.effects) {
    if (!effect.called_for) continue;
    const Way& without = ways[next++];
    effect.rays = own_rays(effect.name, usual.counts, survey.pixels);
    const std::uint64_t rays = all_rays(usual.counts), left = all_rays(without.counts);
    effect.rays_saved = rays - std::min(rays, left);
    const auto ratios = sorted_ratios(without, usual);
    effect.share = 1 - quantile(ratios, 0.5);
    effect.share_low = 1 - quantile(ratios, 0.75);
    effect.share_high = 1 - quantile(ratios, 0.25);
    effect.pixels = different_pixels(usual.planes, without.planes);
  }
  return survey;
}

}  // namespace sir
