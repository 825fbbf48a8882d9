// What a hit sends on: the mirrored and the refracted ray of TRACE (thesis 2.4.1).
#pragma once

#include "tracer/hit.h"

namespace sir {

/// Weights, direction and media of the secondary rays from a hit.
template <typename T>
struct Branching {
  T mirror_weight, through_weight;  ///< ks (+ kt under total reflection), kt; 0 without the effect
  VectorCena<T> through;            ///< refracted direction, if there is one
  bool has_through = false, total_reflection = false;
  T index, index_beyond;  ///< of the medium that the ray came in, and behind the surface
};

/// `index` of the medium that the ray came in; 0 stands for "not known yet": a ray
/// that may begin inside a solid.
template <typename T>
Branching<T> branching_at(const Model<T>& model, const Hit<T>& hit, T index);

}  // namespace sir
