// Our side of the comparison with Embree: many rays' nearest boundaries, one thread.
#pragma once

#include <limits>
#include <vector>

#include "tracer/classify.h"
#include "tracer/model.h"

namespace sir::bench {

/// Where no boundary is.
template <typename T>
inline constexpr T kNothing = std::numeric_limits<T>::infinity();

/// The primary rays of a square image of `side` pixels, row by row.
template <typename T>
std::vector<RayCena<T>> primary_rays(const Model<T>& model, int side);

/// t of the first boundary of each ray, or kNothing. One ray after the other; a way that takes
/// many together has its place here.
template <typename T>
void find_first_hits(Classifier<T>& classifier, const std::vector<RayCena<T>>& rays,
                     std::vector<T>& t);

}  // namespace sir::bench
