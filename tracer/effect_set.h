// Which effects of TRACE, SHADE and TEXTURA (thesis 3.3) a scene calls for; the
// others cost nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracer/scene.h"

namespace sir {

/// Each effect is on only if it is allowed and the scene calls for it.
struct EffectSet {
  bool highlight = true;   ///< the Ks term of the lights
  bool shadow = true;      ///< shadow rays
  bool filter = true;      ///< shadows attenuated by transparent surfaces; else they are black
  bool reflection = true;  ///< mirrored rays
  bool refraction = true;  ///< refracted rays
  bool texture = true;     ///< more than the first coefficients of a surface
  bool bump = true;        ///< perturbed normals; no surface of today has any
  bool antialias = true;   ///< more than one ray a pixel, where it is asked for
  /// Casts every ray of the effects that are on, whether or not it can matter.
  bool exhaustive = false;

  /// The names, in the order of the members.
  static const std::vector<std::string>& names();

  /// The member of that name; nullptr for an unknown one.
  bool* find(std::string_view name);
};

/// The effects of `allowed` that the surfaces reached by the tree and the lights
/// call for. With allowed.exhaustive all that are allowed, but for bump, which no
/// scene has yet. Antialiasing is called for by nothing in a scene, but by whoever
/// wants it (`antialias_wanted`).
EffectSet effects_called_for(const Scene& scene, const EffectSet& allowed,
                             bool antialias_wanted = false);

}  // namespace sir
