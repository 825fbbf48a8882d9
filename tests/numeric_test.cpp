#include "tracer/numeric.h"

#include <gtest/gtest.h>

#include <random>

#include <glm/matrix.hpp>

namespace sir {
namespace {

using N = Numeric<double>;

TEST(Numeric, SameEventIsThirtyTwoUlps) {
  for (const double t : {1.0, 1.999, 2.0, 3.7e-200, 5e100, -4.2}) {
    double near = t, far = t;
    for (int i = 0; i < 32; ++i) near = std::nextafter(near, 1e300);
    far = std::nextafter(near, 1e300);
    EXPECT_TRUE(N::same_event(t, near)) << t;
    EXPECT_FALSE(N::same_event(t, far)) << t;
  }
  EXPECT_TRUE(N::same_event(0, 0));
  EXPECT_FALSE(N::same_event(0, 1e-300));
  EXPECT_FALSE(N::same_event(-std::numeric_limits<double>::infinity(), 1));
  EXPECT_TRUE(Numeric<float>::same_event(1.0f, 1.0f + 31 * 1.1920929e-7f));
  EXPECT_FALSE(Numeric<float>::same_event(1.0f, 1.0f + 34 * 1.1920929e-7f));
}

TEST(Numeric, SameEventDoesNotDependOnScale) {
  const double a = 1.2345678901, b = a + 30 * 2.220446049250313e-16;
  for (int k = -900; k < 900; k += 60)
    EXPECT_EQ(N::same_event(a, b), N::same_event(std::ldexp(a, k), std::ldexp(b, k)));
}

glm::dmat3 columns(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return glm::dmat3(a, b, c); }

TEST(Numeric, SingularIsDecidedExactly) {
  EXPECT_TRUE(is_singular(columns({1, 2, 3}, {4, 5, 6}, {7, 8, 9})));
  EXPECT_TRUE(is_singular(columns({0.1, 0.2, 0.3}, {0, 0, 0}, {1, 1, 1})));
  EXPECT_TRUE(is_singular(columns({0.1, 0.7, 0.3}, {0.1, 0.7, 0.3}, {5, 1, 2})));
  // One ulp away from the singular one: determinant about 1e-16 of the entries.
  EXPECT_FALSE(is_singular(columns({1, 2, 3}, {4, 5, 6}, {7, 8, std::nextafter(9.0, 10.0)})));
  // eps^2 left over after cancellation; beyond quadruple precision's comfort.
  const double up = 1 + 2.220446049250313e-16, down = 1 - 2.220446049250313e-16;
  EXPECT_FALSE(is_singular(columns({1, up, 0}, {down, 1, 0}, {0, 0, 1})));
  // Tiny, not flat.
  EXPECT_FALSE(is_singular(columns({1e-100, 0, 0}, {0, 1e-100, 0}, {0, 0, 1e-100})));
}

glm::dmat3 matrix_of(const Inverse& inverse) {
  glm::dmat3 m;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) m[c][r] = inverse.entry(r, c);
  return m;
}

TEST(Numeric, InverseIsTheNearestDouble) {
  // Integer matrices with determinant 1 have integer inverses.
  const glm::dmat3 m = columns({1, 2, 3}, {0, 1, 4}, {5, 6, 0});
  Inverse inverse;
  ASSERT_TRUE(invert(m, inverse));
  EXPECT_EQ(matrix_of(inverse), columns({-24, 18, 5}, {20, -15, -4}, {-5, 4, 1}));
}

TEST(Numeric, InverseHoldsAtConditionTwelve) {
  // Shears of 1e6 both ways: integers, determinant 1, condition 1e24, exact inverse known.
  const double s = 1e6;
  const glm::dmat3 m = columns({1, 0, 0}, {s, 1, 0}, {0, s, 1});
  Inverse inverse;
  ASSERT_TRUE(invert(m, inverse));
  EXPECT_EQ(matrix_of(inverse), columns({1, 0, 0}, {-s, 1, 0}, {s * s, -s, 1}));
}

TEST(Numeric, ScalingsDivideExactly) {
  for (const double s : {49.0, 98.0, 0.1, 1.0 / 3, 3e-170, 7.0}) {
    Inverse inverse;
    ASSERT_TRUE(invert(columns({s, 0, 0}, {0, 2 * s, 0}, {0, 0, s}), inverse));
    EXPECT_EQ(inverse.numerators[0][0] * s / inverse.divisors[0], 1) << s;
    EXPECT_EQ(inverse.numerators[1][1] * (2 * s) / inverse.divisors[1], 1) << s;
  }
}

TEST(Numeric, IntegerShearsStayExact) {
  const glm::dmat3 m = columns({3, 0, 0}, {1, 3, 0}, {2, 1, 5});
  Inverse inverse;
  ASSERT_TRUE(invert(m, inverse));
  const auto local = [&](glm::dvec3 p) { return (inverse.numerators * p) / inverse.divisors; };
  EXPECT_EQ(local(m * glm::dvec3(1, 0, 1)), glm::dvec3(1, 0, 1));
  EXPECT_EQ(local(m * glm::dvec3(7, -1, 0)), glm::dvec3(7, -1, 0));
  EXPECT_EQ(local(m[2]), glm::dvec3(0, 0, 1));
}

TEST(Numeric, InverseOfRandomMatricesIsAccurate) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    glm::dmat3 m;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) m[c][r] = any(random) * std::pow(10.0, 3 * any(random));
    Inverse inverse;
    ASSERT_TRUE(invert(m, inverse));
    // Residual in extended precision, against the size of the summed terms.
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        long double sum = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
          const long double term = static_cast<long double>(m[k][r]) * inverse.entry(k, c);
          sum += term;
          size += std::abs(term);
        }
        EXPECT_LE(std::abs(sum - (r == c ? 1 : 0)), size * 3.4e-16L);
      }
  }
}

// Regular, singular and nearly singular ones, of every size: the short way to tell
// says what the inverse says.
TEST(Numeric, WhatIsInvertibleHasAnInverse) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  int invertible = 0, refused = 0;
  for (int n = 0; n < 20000; ++n) {
    glm::dmat3 m(0);
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) m[c][r] = n % 4 == 0 ? std::round(2 * any(random)) : any(random);
    if (n % 3 == 0) m[2] = 2.0 * m[0] - m[1];
    for (int c = 0; c < 3; ++c)
      m[c] *= std::ldexp(1.0, static_cast<int>((n % 5) * 200 * any(random)));
    Inverse inverse;
    const bool expected = invert(m, inverse);
    EXPECT_EQ(is_invertible(m), expected) << n;
    ++(expected ? invertible : refused);
  }
  EXPECT_GT(invertible, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(Numeric, ScaledNearOneIsExactPowerOfTwo) {
  for (const glm::dvec3& v : {glm::dvec3(3e-160, -4e-161, 0), glm::dvec3(5e150, 1, -7e149)}) {
    const glm::dvec3 scaled = scaled_near_one(v);
    const double largest = std::max({std::abs(scaled.x), std::abs(scaled.y), std::abs(scaled.z)});
    EXPECT_GE(largest, 1);
    EXPECT_LT(largest, 2);
    EXPECT_EQ(scaled.x / scaled.y, v.x / v.y);
  }
  EXPECT_EQ(scaled_near_one(glm::dvec3(0)), glm::dvec3(0));
}

TEST(Numeric, RowsOfVeryDifferentSizeAreNotSingular) {
  for (const double e : {1e-100, 1e-170, 1e-250, 1e170}) {
    const glm::dmat3 m =
        columns({1, 1.3 * e, 0.7 * e}, {1.1, -0.9 * e, 0.2 * e}, {0.8, 0.4 * e, 1.9 * e});
    EXPECT_FALSE(is_singular(m)) << e;
    Inverse inverse;
    ASSERT_TRUE(invert(m, inverse)) << e;
    // A row of the inverse times its column is 1.
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += inverse.entry(0, k) * m[0][k];
    EXPECT_NEAR(sum, 1, 1e-14) << e;
  }
}

}  // namespace
}  // namespace sir
