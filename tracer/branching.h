// What a hit sends on: the mirrored and the refracted ray of TRACE (thesis 2.4.1).
#pragma once

#include "tracer/hit.h"

namespace sir {

/// The index for Snell's law; a medium of none is air.
template <typename T>
T refraction_index(T index) {
  return index > 0 ? index : T(1);
}

/// Weights, direction and media of the secondary rays from a hit.
template <typename T>
struct Branching {
  T mirror_weight, through_weight;  ///< ks (+ kt under total reflection), kt; 0 without the effect
  VectorCena<T> through;            ///< refracted direction, if there is one
  T index = 0, index_beyond = 0;    ///< of the medium that the ray came in, and behind the surface
  bool has_through = false, total_reflection = false;

  /// There is no refracted direction: the transmitted share joins the mirrored ray.
  void reflect_totally() {
    total_reflection = through_weight > 0;
    mirror_weight += through_weight;
    through_weight = 0;
  }
};

/// Weights and media, of a surface that the ray enters or leaves the solid through;
/// `asks` where it takes a refracted direction to know more.
template <typename T>
Branching<T> branching_before_refraction(const EffectSet& effects, const Reflectance<T>& k,
                                         bool entering, T index, bool& asks);

/// `index` of the medium that the ray came in; 0 stands for "not known yet": a ray
/// that may begin inside a solid.
template <typename T>
Branching<T> branching_at(const Model<T>& model, const Hit<T>& hit, T index);

}  // namespace sir
