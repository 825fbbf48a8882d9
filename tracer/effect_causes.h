// What in a scene calls for the effects of TRACE, SHADE and TEXTURA (thesis 3.3).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tracer/scene.h"

namespace sir {

/// An effect is called for where the one or the other is not empty.
struct EffectCause {
  std::vector<std::size_t> nodes;   ///< primitives reached by the root: indices into
                                    ///< CsgTree::nodes, in the file's order
  std::vector<std::size_t> lights;  ///< indices into Lighting::lights

  bool any() const { return !nodes.empty() || !lights.empty(); }
};

/// The causes of all effects.
struct EffectCauses {
  EffectCause highlight;   ///< surfaces with ks, and lights that shine
  EffectCause shadow;      ///< surfaces that a light can brighten, and those lights
  EffectCause filter;      ///< surfaces with kt, where there are shadows
  EffectCause reflection;  ///< surfaces with ks
  EffectCause refraction;  ///< surfaces with kt
  EffectCause texture;     ///< chequers whose two sets of coefficients differ
};

/// Goes once through the tree, without recursion.
EffectCauses effect_causes(const Scene& scene);

}  // namespace sir
