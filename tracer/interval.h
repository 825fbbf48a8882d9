// Narrowing a ray's interval by one convex boundary after another (for
// INTERSECTA, thesis 2.3.4).
#pragma once

#include <limits>

#include "tracer/intersect.h"
#include "tracer/numeric.h"

namespace sir {

/// Intersection of half-lines and intervals of t, remembering the faces that
/// bound it. Starts as the whole line.
template <typename T>
class Interval {
 public:
  /// Keeps what lies after t. Of faces that coincide the lowest is named.
  void enter_at(T t, std::uint8_t face) {
    if (t > enter_) {
      if (!(face > enter_face_ && Numeric<T>::same_event(enter_, t))) enter_face_ = face;
      enter_ = t;
    } else if (face < enter_face_ && Numeric<T>::same_event(t, enter_)) {
      enter_face_ = face;
    }
  }

  /// Keeps what lies before t.
  void leave_at(T t, std::uint8_t face) {
    if (t < leave_) {
      if (!(face > leave_face_ && Numeric<T>::same_event(t, leave_))) leave_face_ = face;
      leave_ = t;
    } else if (face < leave_face_ && Numeric<T>::same_event(leave_, t)) {
      leave_face_ = face;
    }
  }

  /// Keeps what lies strictly between the planes coordinate = low and
  /// coordinate = high, for a ray whose coordinate is origin + t direction.
  /// False: nothing is left, because the ray runs beside or in a plane.
  bool slab(T origin, T direction, T low, T high, std::uint8_t low_face, std::uint8_t high_face) {
    if (direction == 0) return low < origin && origin < high;
    const T at_low = (low - origin) / direction;
    const T at_high = (high - origin) / direction;
    enter_at(direction > 0 ? at_low : at_high, direction > 0 ? low_face : high_face);
    leave_at(direction > 0 ? at_high : at_low, direction > 0 ? high_face : low_face);
    return true;
  }

  bool to_span(Span<T>& span) const {
    span = {enter_, leave_, enter_face_, leave_face_};
    return enter_ < leave_;
  }

 private:
  static constexpr std::uint8_t kNoFace = 255;
  T enter_ = -std::numeric_limits<T>::infinity();
  T leave_ = std::numeric_limits<T>::infinity();
  std::uint8_t enter_face_ = kNoFace, leave_face_ = kNoFace;
};

/// Both roots of a t^2 + 2 b t + c = 0 for a > 0, given root = sqrt(b^2 - a c)
/// > 0 from a formula that does not cancel.
template <typename T>
struct Roots {
  T low, high;
  Roots(T a, T b, T c, T root) {
    const T q = b > 0 ? -(b + root) : root - b;
    low = q / a;
    high = c / q;
    if (low > high) std::swap(low, high);
  }
};

}  // namespace sir
