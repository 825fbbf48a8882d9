#include "tests/exact_number.h"

#include <cmath>
#include <utility>

namespace sir::test {

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  exponent_ = exponent - 53;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent_;
  }
  mantissa_ = mantissa;
}

Dyadic Dyadic::operator-() const {
  Dyadic result = *this;
  result.mantissa_ = -result.mantissa_;
  return result;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const Dyadic& high = a.exponent_ >= b.exponent_ ? a : b;
  const Dyadic& low = a.exponent_ >= b.exponent_ ? b : a;
  Dyadic result;
  result.exponent_ = low.exponent_;
  result.mantissa_ = high.mantissa_;
  result.mantissa_ <<= static_cast<unsigned>(high.exponent_ - low.exponent_);
  result.mantissa_ += low.mantissa_;
  if (result.mantissa_.is_zero()) result.exponent_ = 0;
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.sign() == 0 || b.sign() == 0) return result;
  result.mantissa_ = a.mantissa_ * b.mantissa_;
  result.exponent_ = a.exponent_ + b.exponent_;
  return result;
}

Real Dyadic::real() const { return ldexp(Real(mantissa_), exponent_); }

int sign_with_root(const Dyadic& u, const Dyadic& v, const Dyadic& d) {
  const int rational = u.sign();
  const int root = d.sign() == 0 ? 0 : v.sign();
  if (rational == 0 || root == 0 || rational == root) return rational != 0 ? rational : root;
  // Opposite signs: the larger square wins.
  return rational * (squared(u) - squared(v) * d).sign();
}

Real ulp(const Real& t, int digits) {
  if (t == 0) return 0;
  int exponent = 0;
  frexp(t, &exponent);
  return ldexp(Real(1), exponent - digits);
}

Comparison compare_events(const Real& a, const Real& b, int digits, const Real& slack) {
  const Real gap = abs(a - b);
  const Real size = (std::max)(Real(abs(a)), Real(abs(b)));
  const Real one = ulp(size, digits);
  const Nearness nearness = gap <= 32 * one ? Nearness::one_event : Nearness::apart;
  // Where |t| is about to cross a power of two, its ulp may be either.
  const Real step = 8 * one + slack;
  const Real least = size > step ? ulp(size - step, digits) : Real(0),
             most = ulp(size + step, digits);
  const bool surely_one = gap + slack < 28 * least;
  const bool surely_apart = gap - slack > 36 * most;
  return {nearness, gap == 0 && slack == 0 ? true : surely_one || surely_apart};
}

}  // namespace sir::test
