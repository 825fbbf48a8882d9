// Numbers wide enough that sums and products of a scene's numbers are exact:
// the last word of INTERSECTA (thesis 2.3.4), where twice the digits of double
// do not decide either, as on an exact tangent.
#pragma once

#include <cmath>

#include <gmpxx.h>

namespace sir {

/// A floating-point number of kBits bits (GMP). A discriminant is a sum of
/// products of twelve of the file's doubles: it is exact as long as these lie
/// within 2^600 of one another. Quotients and roots are good to kBits bits;
/// roots of squares are exact. The exponent has no limit that matters.
class Wide {
 public:
  static constexpr unsigned kBits = 8192;

  Wide(double value = 0) : v_(value, kBits) {}  // NOLINT(google-explicit-constructor)

  friend Wide operator+(const Wide& a, const Wide& b) { return Wide(mpf_class(a.v_ + b.v_)); }
  friend Wide operator-(const Wide& a, const Wide& b) { return Wide(mpf_class(a.v_ - b.v_)); }
  friend Wide operator*(const Wide& a, const Wide& b) { return Wide(mpf_class(a.v_ * b.v_)); }
  friend Wide operator/(const Wide& a, const Wide& b) { return Wide(mpf_class(a.v_ / b.v_)); }
  friend Wide operator-(const Wide& a) { return Wide(mpf_class(-a.v_)); }
  friend Wide square_root(const Wide& a) { return Wide(mpf_class(sqrt(a.v_))); }

  /// value times 2^exponent, exactly.
  friend Wide times_power_of_two(const Wide& a, int exponent) {
    mpf_class result(0, kBits);
    if (exponent >= 0) mpf_mul_2exp(result.get_mpf_t(), a.v_.get_mpf_t(), unsigned(exponent));
    else mpf_div_2exp(result.get_mpf_t(), a.v_.get_mpf_t(), unsigned(-exponent));
    return Wide(result);
  }

  /// The nearest double (GMP's own conversion cuts off).
  friend double to_double(const Wide& a) {
    const double cut = a.v_.get_d();
    if (!std::isfinite(cut)) return cut;
    return cut + mpf_class(a.v_ - cut).get_d();
  }
  /// a times 2^exponent as the nearest T wider than double, but for the last of
  /// three doubles' digits.
  template <typename T>
  friend T nearest_wider(const Wide& a, int exponent) {
    long shift = 0;
    const double first = mpf_get_d_2exp(&shift, a.v_.get_mpf_t());
    const Wide rest = times_power_of_two(a, static_cast<int>(-shift)) - Wide(first);
    const double second = rest.v_.get_d();
    const T low = T(second) + T(mpf_class(rest.v_ - second).get_d());
    return std::ldexp(T(first) + low, static_cast<int>(shift) + exponent);
  }
  friend int sign_of(const Wide& a) { return sgn(a.v_); }

 private:
  explicit Wide(const mpf_class& value) : v_(value) {}
  mpf_class v_;
};

}  // namespace sir
