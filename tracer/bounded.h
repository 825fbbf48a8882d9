// Arithmetic that knows its own error (running error analysis: Wilkinson,
// Rounding Errors in Algebraic Processes, 1963), for the decisions of
// INTERSECTA (thesis 2.3.4).
#pragma once

#include <cmath>

#include "tracer/double_double.h"
#include "tracer/wide.h"

namespace sir {

/// The relative error of one operation on S; 0 where it is exact.
template <typename S>
struct Rounding;
template <>
struct Rounding<DoubleDouble> {
  static constexpr double kSum = 0x1p-102, kQuotient = 0x1p-100;
  static constexpr bool kFinal = false;

  /// Sums and products of two plain doubles have no error, unless they are so
  /// small that the low part is lost, or too large: then nothing is known.
  static double of(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& result) {
    if (a.lo == 0 && b.lo == 0 && std::isfinite(result.hi)) return 0;
    return std::abs(result.hi) * kSum;
  }
  /// What a product of numbers that are not exactly 0 may lose by being small.
  static double lost(const DoubleDouble& product) {
    return std::abs(product.hi) < 0x1p-900 ? 0x1p-950 : 0;
  }
};
template <>
struct Rounding<Wide> {
  static constexpr bool kFinal = true;  ///< what is not told apart here is equal

  static double of(const Wide&, const Wide&, const Wide&) { return 0; }
  static double lost(const Wide&) { return 0; }
};

/// A number and how far from it the true one may lie: nowhere in Wide, but for
/// quotients and roots, whose errors are far below anything that is asked.
template <typename S>
struct Bounded {
  S value{};
  double error = 0;

  static Bounded exactly(double x) { return {S{x}, 0}; }
  bool is_zero() const { return error == 0 && sign_of(value) == 0; }
  double size() const { return std::abs(to_double(value)); }

  friend Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    Bounded sum{a.value + b.value, a.error + b.error};
    sum.error += Rounding<S>::of(a.value, b.value, sum.value);
    return sum;
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    Bounded product{a.value * b.value, 0};
    if (a.error > 0 || b.error > 0)
      product.error = (a.size() * b.error + b.size() * a.error + a.error * b.error) * kSlack;
    product.error += Rounding<S>::of(a.value, b.value, product.value);
    if (!a.is_zero() && !b.is_zero()) product.error += Rounding<S>::lost(product.value);
    return product;
  }
  /// b must be known not to be zero.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    Bounded quotient{a.value / b.value, 0};
    if constexpr (!Rounding<S>::kFinal)
      quotient.error = (a.error + quotient.size() * b.error) / (b.size() - b.error) * kSlack +
                       quotient.size() * Rounding<S>::kQuotient;
    return quotient;
  }
  /// a must be known to be positive.
  friend Bounded square_root(const Bounded& a) {
    Bounded root{square_root(a.value), 0};
    if constexpr (!Rounding<S>::kFinal)
      root.error = a.error / root.size() * kSlack + root.size() * Rounding<S>::kQuotient;
    return root;
  }

 private:
  static constexpr double kSlack = 1 + 0x1p-40;  // the bounds themselves are rounded
};

/// Asks for signs and remembers whether every answer was certain. After an
/// uncertain one whatever was computed is to be thrown away.
template <typename S>
class Decisions {
 public:
  bool certain() const { return certain_; }
  /// Says that something else was not certain, unless S is the last word.
  void doubt() { certain_ = certain_ && Rounding<S>::kFinal; }

  /// -1, 0 or 1.
  int sign(const Bounded<S>& x) {
    if (x.error == 0 || x.size() > x.error) return sign_of(x.value);
    doubt();
    return 0;
  }

  /// Whether the quotient or root b is greater than a. In the last resort what
  /// agrees in 900 bits is equal.
  bool after(const Bounded<S>& a, const Bounded<S>& b) {
    const Bounded<S> gap = b - a;
    if (sign(gap) <= 0) return false;
    if constexpr (!Rounding<S>::kFinal) return true;
    const S size = sign_of(b.value) < 0 ? -b.value : b.value;
    return sign_of(gap.value - times_power_of_two(size, -900)) > 0;
  }

 private:
  bool certain_ = true;
};

}  // namespace sir
