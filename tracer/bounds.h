// Envelopes (thesis 2.5.2): boxes along the axes of SC_CENA.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/frames.h"
#include "tracer/intersect.h"
#include "tracer/numeric.h"

namespace sir {

/// A box with faces parallel to the axes of SC_CENA; empty where low > high.
template <typename T>
struct Bounds {
  glm::vec<3, T> low{std::numeric_limits<T>::infinity()};
  glm::vec<3, T> high{-std::numeric_limits<T>::infinity()};

  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  /// Whether the two come as near as `gap` along every axis.
  bool near(const Bounds& other, T gap) const {
    // No branch: which of the six it is cannot be foreseen.
    return bool((low.x <= other.high.x + gap) & (other.low.x <= high.x + gap) &
                (low.y <= other.high.y + gap) & (other.low.y <= high.y + gap) &
                (low.z <= other.high.z + gap) & (other.low.z <= high.z + gap));
  }
  glm::vec<3, T> centre() const { return low / T(2) + high / T(2); }
};

/// The envelope of a primitive, tight but for rounding. Of the placement only the way to SC_CENA
/// counts.
template <typename T>
Bounds<T> tight_bounds_of(PrimitiveKind kind, const LocalCena<T>& placement);

/// The same, widened by the roundings of Numeric::kBoxRoundings.
template <typename T>
Bounds<T> bounds_of(PrimitiveKind kind, const LocalCena<T>& placement);

/// A ray prepared for many box tests. Its origin may be `widening` aside along any axis.
template <typename T>
class BoxProbe {
 public:
  explicit BoxProbe(const RayCena<T>& ray, T widening = 0)
      : before_(ray.origin.v - widening), beyond_(ray.origin.v + widening) {
    for (int axis = 0; axis < 3; ++axis) {
      const T d = ray.direction.v[axis];
      reciprocal_[axis] = T(1) / d;
      parallel_[axis] = !std::isfinite(reciprocal_[axis]);
    }
  }

  /// Whether the line meets the box at some t in [0, farthest]. Never false
  /// where a solid in the box is hit; may be true where it is not.
  bool meets(const Bounds<T>& box, T farthest) const { return !std::isnan(entry(box, farthest)); }

  /// Where it meets the box first, at t in [0, farthest], a few roundings of t
  /// aside and no more than `farthest`; not a number where it does not.
  T entry(const Bounds<T>& box, T farthest) const {
    constexpr T kMissed = std::numeric_limits<T>::quiet_NaN();
    T enter = 0, leave = farthest;
    for (int axis = 0; axis < 3; ++axis) {
      const T to_low = box.low[axis] - beyond_[axis];
      const T to_high = box.high[axis] - before_[axis];
      if (parallel_[axis]) {
        if (to_low > 0 || to_high < 0) return kMissed;
        continue;
      }
      const T a = to_low * reciprocal_[axis], b = to_high * reciprocal_[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    // The quotients are good to a few roundings of t.
    return enter <= leave * (1 + 8 * Numeric<T>::kEpsilon) ? std::min(enter, farthest) : kMissed;
  }

 private:
  glm::vec<3, T> before_, beyond_, reciprocal_;
  bool parallel_[3];
};

}  // namespace sir
