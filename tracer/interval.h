// Narrowing a ray's interval by one convex boundary after another (for
// INTERSECTA, thesis 2.3.4), with bounds of what rounding may have done.
#pragma once

#include <limits>
#include <utility>

#include "tracer/intersect.h"
#include "tracer/numeric.h"

namespace sir {

/// The relative error of one operation on T. In bounds it is multiplied by the
/// number of operations on the way, rounded up; factors a little above 1 or 2
/// stand for products of errors.
template <typename T>
inline constexpr T kUnitRoundoff = Numeric<T>::kEpsilon / 2;

/// A root or a crossing with a bound of its error.
template <typename T>
struct Located {
  T t, error;
};

/// Intersection of half-lines and intervals of t, remembering the faces that
/// bound it. Starts as the whole line.
template <typename T>
class Interval {
 public:
  /// Keeps what lies after `at`.
  void enter_at(Located<T> at, std::uint8_t face) {
    if (at.t > enter_.t) {
      std::swap(at, enter_);
      enter_face_ = face;
    }
    enter_rival_ = std::max(enter_rival_, at.t + at.error);
  }

  /// Keeps what lies before `at`.
  void leave_at(Located<T> at, std::uint8_t face) {
    if (at.t < leave_.t) {
      std::swap(at, leave_);
      leave_face_ = face;
    }
    leave_rival_ = std::min(leave_rival_, at.t - at.error);
  }

  /// Keeps what lies strictly between the planes coordinate = 0 and
  /// coordinate = unit. `crosses`: go on.
  Crossing slab(const LocalRay<T>& ray, int axis, std::uint8_t low_face, std::uint8_t high_face) {
    const T o = ray.origin.v[axis], d = ray.direction.v[axis];
    const T o_error = ray.origin_error[axis], d_error = ray.direction_error[axis];
    if (d == 0 && d_error == 0) {  // parallel without a doubt
      return inside_slab(std::min(o, ray.unit - o),
                         o_error + ray.unit_error + 2 * kUnitRoundoff<T> * ray.unit);
    }
    if (!(std::abs(d) > kSteep * d_error)) return Crossing::unsure;
    const Located<T> low = plane(-o, o_error, d, d_error);
    const Located<T> high = plane(ray.unit - o, o_error + ray.unit_error, d, d_error);
    enter_at(d > 0 ? low : high, d > 0 ? low_face : high_face);
    leave_at(d > 0 ? high : low, d > 0 ? high_face : low_face);
    return Crossing::crosses;
  }

  /// Whether a line along two planes lies between them, given the distance from
  /// the nearer one, negative outside.
  static Crossing inside_slab(T depth, T error) {
    if (depth > error) return Crossing::crosses;
    return depth < -error ? Crossing::misses : Crossing::unsure;
  }

  /// distance / d, a coordinate's way to a plane, for |d| > kSteep errors of d.
  /// Besides the errors given the distance and the quotient are rounded.
  static Located<T> plane(T distance, T distance_error, T d, T d_error) {
    const T t = distance / d, size = std::abs(t);
    return {t, T(1.04) * (distance_error + size * d_error) / std::abs(d) +
                   T(2.1) * kUnitRoundoff<T> * size};
  }
  static constexpr T kSteep = 32;

  /// The last word on what is left.
  Crossing to_span(Span<T>& span) const {
    const T gap = leave_.t - enter_.t, error = enter_.error + leave_.error;
    if (!(gap > error)) return gap < -error ? Crossing::misses : Crossing::unsure;
    // Faces that coincide, or nearly: which one is named, and where it is.
    if (!(enter_.t - enter_rival_ > enter_.error + same_event(enter_.t)) ||
        !(leave_rival_ - leave_.t > leave_.error + same_event(leave_.t)))
      return Crossing::unsure;
    span = {enter_.t, leave_.t, enter_.error, leave_.error, enter_face_, leave_face_};
    return Crossing::crosses;
  }

 private:
  // A little more than the distance within which boundaries are one event.
  static T same_event(T t) {
    return 2 * Numeric<T>::kCoincidentUlps * Numeric<T>::kEpsilon * std::abs(t);
  }

  static constexpr T kInfinity = std::numeric_limits<T>::infinity();
  Located<T> enter_{-kInfinity, 0}, leave_{kInfinity, 0};
  T enter_rival_ = -kInfinity, leave_rival_ = kInfinity;  // the nearest that is not the end
  std::uint8_t enter_face_ = 0, leave_face_ = 0;
};

/// A quadratic a t^2 + 2bt + c with its reduced discriminant b^2 - ac, taken
/// from a formula that does not cancel, each with a bound of its error.
template <typename T>
struct Quadratic {
  T a, b, c, discriminant;
  T a_error, b_error, c_error, discriminant_error;

  /// Both roots, lower first; false where they are too near to one another, or
  /// a too near to 0, to bound their errors well.
  bool roots(Located<T>& low, Located<T>& high) const {
    if (!(discriminant > 16 * discriminant_error) || !(std::abs(a) > 4 * a_error)) return false;
    const T root = std::sqrt(discriminant);
    const T q = b > 0 ? -(b + root) : root - b;
    const T size = std::abs(q);
    const T q_error = b_error + discriminant_error / root + 3 * kUnitRoundoff<T> * size;
    if (!(size > 4 * q_error)) return false;
    low = quotient(q, q_error, a, a_error);
    high = quotient(c, c_error, q, q_error);
    if (low.t > high.t) std::swap(low, high);
    return true;
  }

 private:
  // For a denominator of more than four times its error.
  static Located<T> quotient(T n, T n_error, T d, T d_error) {
    const T t = n / d, size = std::abs(t);
    return {t, T(1.4) * (n_error + size * d_error) / std::abs(d) + 2 * kUnitRoundoff<T> * size};
  }
};

/// Whether the sums of a ray's coordinates are such that the bounds hold: they
/// take errors of the direction to be small, and products of four numbers
/// neither to overflow nor to sink to where T loses digits.
template <typename T>
bool moderate(T origin, T origin_error, T direction, T direction_error) {
  constexpr T kMost = Numeric<T>::kModerate;
  return origin + origin_error < kMost && direction < kMost && direction > 1 / kMost &&
         direction_error * 64 < direction;
}

template <typename T>
T sum_of(const glm::vec<3, T>& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace sir
