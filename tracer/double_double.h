// Twice the digits of double by error-free transforms (Dekker 1971; Knuth, The
// Art of Computer Programming 4.2.2): what INTERSECTA (thesis 2.3.4) computes
// with where the rounding of double could decide.
#pragma once

#include <cmath>

namespace sir {

/// hi + lo, |lo| at most half a unit in the last place of hi: about 106 bits.
/// Sums, differences and products have relative errors below 2^-102, quotients
/// and roots below 2^-100 (Joldes, Muller, Popescu, ACM TOMS 44, 2017), unless
/// a product falls below 2^-960, where its low part is lost.
struct DoubleDouble {
  double hi = 0, lo = 0;
};

/// a + b without error.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The same for |a| >= |b|.
inline DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b without error.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo);
  const DoubleDouble sum = fast_two_sum(high.hi, high.lo + low.hi);
  return fast_two_sum(sum.hi, low.lo + sum.lo);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_product(a.hi, b.hi);
  return fast_two_sum(high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = a - b * DoubleDouble{first, 0};
  const double second = rest.hi / b.hi;
  const DoubleDouble last = rest - b * DoubleDouble{second, 0};
  return fast_two_sum(first, second) + DoubleDouble{last.hi / b.hi, 0};
}

inline DoubleDouble square_root(DoubleDouble a) {
  if (!(a.hi > 0)) return {std::sqrt(a.hi), 0};
  const double root = std::sqrt(a.hi);
  const DoubleDouble rest = a - two_product(root, root);
  const DoubleDouble better = fast_two_sum(root, rest.hi / (2 * root));
  const DoubleDouble last = a - better * better;
  return better + DoubleDouble{last.hi / (2 * root), 0};
}

inline double to_double(DoubleDouble a) { return a.hi + a.lo; }
inline DoubleDouble times_power_of_two(DoubleDouble a, int exponent) {
  return {std::ldexp(a.hi, exponent), std::ldexp(a.lo, exponent)};
}
/// a times 2^exponent as the nearest T wider than double.
template <typename T>
T nearest_wider(DoubleDouble a, int exponent) {
  return std::ldexp(T(a.hi) + T(a.lo), exponent);
}
inline int sign_of(DoubleDouble a) { return (a.hi > 0) - (a.hi < 0); }

}  // namespace sir
