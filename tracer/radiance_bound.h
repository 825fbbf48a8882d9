// The most that a ray can bring (for TRACE, thesis 2.4.3, equation 2.1).
#pragma once

#include <algorithm>
#include <vector>

#include "tracer/model.h"
#include "tracer/trace_options.h"

namespace sir {

/// Upper bounds of a ray's radiance by the depth of what it hits, channel by
/// channel. B, the largest over the tree's surfaces (and the background) of
/// Ia Ka + sum If (Kd + Ks) + (Ks + Kt) B', where B' is the bound one depth
/// further on, and what stands for it at the depth limit.
template <typename T>
class RadianceBound {
 public:
  RadianceBound(const Model<T>& model, const TraceOptions& options);

  /// Whether there is any bound: a kt above 1 lets light grow on its way through
  /// surfaces, as often as there are any; and coefficients may overflow T.
  bool bounded() const { return bounded_; }

  /// Of a ray that hits at `depth`, 1 for a primary one.
  const Colour<T>& at(int depth) const {
    const auto left = static_cast<std::size_t>(std::max(0, depth_limit_ - depth));
    return by_depth_left_[std::min(left, by_depth_left_.size() - 1)];
  }

 private:
  int depth_limit_;
  bool bounded_ = true;
  std::vector<Colour<T>> by_depth_left_;  // the last one holds for any more
};

}  // namespace sir
