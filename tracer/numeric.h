// The tolerances of the tracer, all of them, and the arithmetic that needs more
// than T (the thesis's BASICO, 3.3, has only plain arithmetic). Nothing here
// depends on the scale of a scene. Everything is compiled without contraction to
// fused multiply-adds: they would make exact touches depend on the processor.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace sir {

/// T, but no narrower than the files' numbers: what is prepared once is prepared
/// in this.
template <typename T>
using AtLeastDouble =
    std::conditional_t<(std::numeric_limits<T>::digits < std::numeric_limits<double>::digits),
                       double, T>;

/// Whether a T needs more than one double to hold it. On x86 a long double has
/// 64 binary digits; where it is the same as double, so is all that is done in it.
template <typename T>
inline constexpr bool kWiderThanDouble =
    std::numeric_limits<T>::digits > std::numeric_limits<double>::digits;

/// 2^exponent for constants, 0 where T has no such number.
template <typename T>
constexpr T power_of_two(int exponent) {
  T power = 1;
  for (; exponent < 0; ++exponent) power /= 2;
  for (; exponent > 0; --exponent) power *= 2;
  return power;
}

template <typename T>
struct Numeric {
  static constexpr T kEpsilon = std::numeric_limits<T>::epsilon();

  /// The files' numbers are doubles. Faces that are meant to coincide miss one
  /// another by roundings of double, however finely t is known: in a wider T
  /// what is "the same place" is as wide as in double.
  static constexpr T kGrain =
      kWiderThanDouble<T>
          ? power_of_two<T>(std::numeric_limits<T>::digits - std::numeric_limits<double>::digits)
          : T(1);

  /// Boundaries of a ray closer than this many units in the last place of t
  /// are one event: coincident faces are computed by different matrices and
  /// differ by a few roundings. 32, of double's where T is wider.
  static constexpr T kCoincidentUlps = 32 * kGrain;

  /// Roundings between the true start of a secondary ray and the computed one,
  /// in units of the coordinates that went into it.
  static constexpr T kStartRoundings = 8 * kGrain;

  /// Boundaries are worked out with more digits where they may be off by more than this
  /// many roundings: 1e-12 of t in double, 1e-4 in float.
  static constexpr T kTrustedRoundings = std::numeric_limits<T>::digits < 53 ? 1024 : 4096;

  /// Up to as many primitives times kEpsilon, chains of all of them are still short
  /// on a ray; beyond, it pays to know how many can be in one place.
  static constexpr T kFineChain = power_of_two<T>(-33);

  /// Boxes are widened by as many roundings of the numbers that went into them,
  /// so that they never hide a hit.
  static constexpr T kBoxRoundings = 64 * kGrain;

  /// Products of two numbers of this size are normal still.
  static constexpr T kWellAboveUnderflow = std::numeric_limits<T>::max_exponent > 16000
                                               ? power_of_two<T>(-8000)
                                           : std::numeric_limits<T>::max_exponent > 200 ? T(1e-140)
                                                                                        : T(1e-18f);

  /// Products of four numbers below this, and above its reciprocal, neither
  /// overflow nor lose digits.
  static constexpr T kModerate = std::numeric_limits<T>::max_exponent > 16000
                                     ? power_of_two<T>(4000)
                                 : std::numeric_limits<T>::max_exponent > 200 ? T(1e70)
                                                                              : T(1e8f);

  /// Distance from |t| to the next larger number.
  static T ulp(T t) {
    const T size = std::abs(t);
    return std::nextafter(size, std::numeric_limits<T>::infinity()) - size;
  }

  /// Whether boundaries at a <= b are one event.
  static bool same_event(T a, T b) {
    const T gap = b - a;
    const T size = std::max(std::abs(a), std::abs(b));
    if (gap > kCoincidentUlps * kEpsilon * size) return false;  // ulp(t) <= epsilon |t|
    return gap <= kCoincidentUlps * ulp(size);
  }
};

/// |v| component by component, without the branches of glm::abs.
template <typename T>
glm::vec<3, T> magnitudes(const glm::vec<3, T>& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// The largest component of v by magnitude.
template <typename T>
T largest(const glm::vec<3, T>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// `v` times a power of two that brings its largest component near 1 (zero stays
/// zero), so that squares neither overflow nor underflow. Exact.
template <typename T>
glm::vec<3, T> scaled_near_one(const glm::vec<3, T>& v);

/// Whether the determinant is exactly zero, decided without rounding, so that a
/// tiny solid is not taken for a flat one. Entries must be finite.
bool is_singular(const glm::dmat3& m);

/// v times 2^exponent: std::ldexp(), where a product does the same faster.
template <typename T>
T times_power_of_two(T v, int exponent) {
  if constexpr (std::is_same_v<T, double>)
    if (exponent >= -1022 && exponent <= 1023)
      return v * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  return std::ldexp(v, exponent);
}

/// The inverse of a 3x3 matrix, row by row as numerators over a divisor. Of the
/// many ways to write it, one whose products stay exact as long as can be:
/// cofactors over the determinant, but where these do not fit into T an
/// axis of its own, as in a scaling, is just divided by its length.
template <typename T>
struct InverseIn {
  glm::mat<3, 3, T> numerators{T(1)};  ///< numerators[column][row]
  glm::vec<3, T> divisors{T(1)};       ///< of each row, in [1,2)
  bool exact[3] = {true, true, true};  ///< of each row: no number in it is rounded
  T entry(int row, int column) const { return numerators[column][row] / divisors[row]; }
};
using Inverse = InverseIn<double>;

/// The inverse, each number off by less than a unit in its last place whatever
/// the condition: cofactors and determinant are summed without rounding. False
/// where the matrix is singular or its inverse does not fit. T: double or wider.
template <typename T>
bool invert(const glm::dmat3& m, InverseIn<T>& inverse);

/// Whether invert() will do in double.
bool is_invertible(const glm::dmat3& m);

}  // namespace sir
