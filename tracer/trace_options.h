// What a person may choose about TRACE (thesis 3.3).
#pragma once

#include <cstdint>

#include "tracer/classify.h"
#include "tracer/effect_set.h"

namespace sir {

/// What stands for R and T where the depth limit cuts them off (2.4.3).
enum class PastLimit : std::uint8_t { zero, background };

struct TraceOptions {
  int depth_limit = 5;  ///< a primary hit has depth 1; secondary rays are cast below the limit
  double cutoff = 0;    ///< adaptive control: no secondary ray of less weight (Hall 1983)
  PastLimit past_limit = PastLimit::zero;
  EffectSet allowed_effects;
  Engine engine = Engine::gates;
  bool packets = true;                   ///< rays go by packets, where the engine is `gates`
  Formulas formulas = Formulas::robust;  ///< what render() makes the Model for

  /// No rays beyond the first: for who asks what a ray meets, and not what is seen there.
  static TraceOptions primary_rays_only() {
    TraceOptions options;
    options.depth_limit = 1;
    options.allowed_effects.shadow = false;
    return options;
  }

  /// Of those allowed, the effects that the depth limit leaves room for: at a
  /// limit of 1 nothing is mirrored or refracted, unless it stands for the
  /// background.
  EffectSet possible_effects() const {
    EffectSet set = allowed_effects;
    if (depth_limit == 1 && past_limit == PastLimit::zero && !set.exhaustive)
      set.reflection = set.refraction = false;
    return set;
  }
};

}  // namespace sir
