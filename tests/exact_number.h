// Numbers for the oracle: dyadic rationals without any rounding, and reals of a
// hundred digits for what is irrational (roots).
#pragma once

// GCC 12 takes the unused half of a cpp_int's union for an uninitialised one.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

namespace sir::test {

/// A real of 100 decimal digits: values of t, never a decision that hangs on
/// equality.
using Real = boost::multiprecision::cpp_bin_float_100;

/// mantissa 2^exponent, exact. Every double is one, and sums, differences and
/// products of them are; what would need a division is kept homogeneous.
class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(double value);  // NOLINT: doubles are dyadic

  Dyadic operator-() const;
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

  int sign() const { return mantissa_.sign(); }
  Real real() const;

 private:
  using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                boost::multiprecision::et_off>;
  Integer mantissa_ = 0;
  int exponent_ = 0;
};

inline Dyadic squared(const Dyadic& a) { return a * a; }

/// The sign of u + v sqrt(d) for d >= 0, exactly.
int sign_with_root(const Dyadic& u, const Dyadic& v, const Dyadic& d);

/// Distance from |t| to the next larger number of `digits` binary digits (53 or
/// 24), as if exponents had no end; 0 for t = 0.
Real ulp(const Real& t, int digits);

/// What the rule of 32 ulp says about boundaries at a and b.
enum class Nearness { one_event, apart };

struct Comparison {
  Nearness nearness;
  bool definite;  ///< false: rounding of a and b, or `slack`, could turn it round
};

/// Compares the gap with 32 ulp of the larger |t|. Between 28 and 36 ulp the
/// answer is indefinite; so it is where moving a and b by `slack` in all could
/// bring it there.
Comparison compare_events(const Real& a, const Real& b, int digits, const Real& slack = 0);

}  // namespace sir::test
