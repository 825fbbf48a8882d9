// What the effects of a scene cost, and what they change: the scene with each
// of them forbidden beside the scene with all (the thesis has none; compare 4.3).
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "tracer/effect_causes.h"
#include "tracer/render.h"

namespace sir {

struct EffectCost {
  std::string name;  ///< as in EffectSet::names()
  bool called_for = false;
  EffectCause cause;
  // Of an effect that is not called for all that follows is 0.
  std::uint64_t rays = 0;        ///< cast for it: shadow, dimmed shadow, mirrored, refracted
                                 ///< rays, samples beyond one a pixel
  std::uint64_t rays_saved = 0;  ///< rays of any kind that are not cast without it
  /// Of the processor time of tracing: 1 - without/with, median and quartiles of
  /// pairs of runs. Below 0 where the image without it is the dearer one.
  double share = 0, share_low = 0, share_high = 0;
  std::size_t pixels = 0;  ///< that are others without it
};

struct EffectSurvey {
  std::vector<EffectCost> effects;  ///< all, in the order of EffectSet::names()
  std::size_t pixels = 0;           ///< of the image
  RayCounts counts, all_counts;     ///< as called for; with every effect's rays cast
  double ms = 0;                    ///< processor time of tracing, median
  double all_ratio = 0;             ///< all / as called for, median of pairs
  bool all_equal = false;           ///< whether both images are the same
  bool complete = true;             ///< false: stopped before the end; nothing is known
};

/// Renders with `options`, with each effect forbidden that is called for, and with
/// all effects' rays, in turn: once to warm up, and `repeats` timed times.
EffectSurvey survey_effects(const Scene& scene, const RenderOptions& options, int repeats,
                            const std::function<void(double)>& progress = {},
                            std::stop_token stop = {});

}  // namespace sir
