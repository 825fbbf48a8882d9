#include "tracer/numeric.h"

#include <algorithm>
#include <optional>

#include "tracer/exact_sum.h"

namespace sir {
namespace {

// A matrix with rows and columns scaled by powers of two to near 1, so that
// products of three entries neither overflow nor underflow.
struct Balanced {
  glm::dmat3 m{0.0};  // m[c][r] times 2^(row[r] + column[c]) is the entry
  int row[3] = {}, column[3] = {};
};

std::optional<Balanced> balanced(const glm::dmat3& m) {
  Balanced result;
  result.m = m;
  for (int r = 0; r < 3; ++r) {
    const double largest = std::max({std::abs(m[0][r]), std::abs(m[1][r]), std::abs(m[2][r])});
    if (largest == 0) return std::nullopt;
    result.row[r] = std::ilogb(largest);
    for (int c = 0; c < 3; ++c) result.m[c][r] = times_power_of_two(m[c][r], -result.row[r]);
  }
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3& v = result.m[c];
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return std::nullopt;
    result.column[c] = std::ilogb(largest);
    for (int r = 0; r < 3; ++r) result.m[c][r] = times_power_of_two(v[r], -result.column[c]);
  }
  return result;
}

ExactSum determinant(const glm::dmat3& a) {
  ExactSum sum;
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3, e = (c + 2) % 3;
    sum.add_product(a[c][0], a[d][1], a[e][2]);
    sum.add_product(-a[c][0], a[e][1], a[d][2]);
  }
  return sum;
}

// Entry (row, column) of the adjugate.
ExactSum cofactor(const glm::dmat3& a, int row, int column) {
  const int c1 = (row + 1) % 3, c2 = (row + 2) % 3, r1 = (column + 1) % 3, r2 = (column + 2) % 3;
  ExactSum sum;
  sum.add_product(a[c1][r1], a[c2][r2]);
  sum.add_product(-a[c2][r1], a[c1][r2]);
  return sum;
}

// A determinant or cofactor, and whether the T is surely the number itself. Zero is zero.
template <typename T>
struct Rounded {
  T value;
  bool exact;
};

// The double that ExactSum::value() gives, taken from the same sum in twice the digits
// of double where they leave no doubt of it: nearly always, at a tenth of the time.
//
// Balanced entries are below 2, so the products of a sum are below 48 together, and both
// ways to add them up are off by less than 2^-90 before the last rounding. Where the low
// part is above the doubt the sum is no double, and not zero.
template <typename T, typename Exactly>
Rounded<T> rounded(DoubleDouble quick, Exactly&& exactly) {
  constexpr double kDoubt = 0x1p-85;
  if constexpr (!kWiderThanDouble<T>)
    if (std::abs(quick.lo) > kDoubt && quick.hi + (quick.lo + kDoubt) == quick.hi &&
        quick.hi + (quick.lo - kDoubt) == quick.hi)
      return {T(quick.hi), false};
  const ExactSum sum = exactly();
  return {sum.value<T>(), sum.is_a<T>()};
}

// cofactor() in twice the digits of double.
DoubleDouble quick_cofactor(const glm::dmat3& a, int row, int column) {
  const int c1 = (row + 1) % 3, c2 = (row + 2) % 3, r1 = (column + 1) % 3, r2 = (column + 2) % 3;
  return two_product(a[c1][r1], a[c2][r2]) - two_product(a[c2][r1], a[c1][r2]);
}

// The row's numerators are divided by `divisor`; scaled by powers of two so that
// it comes to lie in [1,2) and coordinates in SC_LOCAL have their natural size
// even before the division.
template <typename T>
void set_divisor(InverseIn<T>& inverse, int row, T divisor) {
  const int shift = -std::ilogb(divisor);
  const T sign = divisor < 0 ? T(-1) : T(1);
  inverse.divisors[row] = sign * times_power_of_two(divisor, shift);
  for (int c = 0; c < 3; ++c)
    inverse.numerators[c][row] = sign * times_power_of_two(inverse.numerators[c][row], shift);
}

}  // namespace

template <typename T>
glm::vec<3, T> scaled_near_one(const glm::vec<3, T>& v) {
  const T largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

bool is_singular(const glm::dmat3& m) {
  const auto scaled = balanced(m);
  return !scaled || determinant(scaled->m).is_zero();
}

template <typename T>
bool invert(const glm::dmat3& m, InverseIn<T>& inverse) {
  const auto scaled = balanced(m);
  if (!scaled) return false;
  DoubleDouble quick[3][3], quick_determinant;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      quick[row][column] = quick_cofactor(scaled->m, row, column);
    quick_determinant = quick_determinant + quick[row][0] * DoubleDouble{scaled->m[row][0], 0};
  }
  const auto det = rounded<T>(quick_determinant, [&] { return determinant(scaled->m); });
  if (det.value == 0) return false;

  bool all_exact = det.exact;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const auto entry =
          rounded<T>(quick[row][column], [&] { return cofactor(scaled->m, row, column); });
      inverse.numerators[column][row] = entry.value;
      all_exact = all_exact && entry.exact;
    }
  for (int row = 0; row < 3; ++row) {
    T divisor = det.value;
    inverse.exact[row] = all_exact;
    int only = -1, entries = 0;
    for (int column = 0; column < 3; ++column)
      if (inverse.numerators[column][row] != 0) {
        only = column;
        ++entries;
      }
    if (!all_exact && entries == 1) {
      // An axis of its own: then the matrix itself holds the divisor.
      inverse.numerators[only][row] = 1;
      inverse.exact[row] = true;
      divisor = scaled->m[row][only];
    }
    set_divisor(inverse, row, divisor);
    for (int column = 0; column < 3; ++column) {
      // The way back: columns of the matrix are rows of the inverse.
      T& entry = inverse.numerators[column][row];
      const T balanced_entry = entry;
      const int exponent = -scaled->column[row] - scaled->row[column];
      entry = times_power_of_two(entry, exponent);
      if (!std::isfinite(entry)) return false;
      if (times_power_of_two(entry, -exponent) != balanced_entry) inverse.exact[row] = false;
    }
  }
  return true;
}

bool is_invertible(const glm::dmat3& m) {
  // Most are seen to be by their size, far from where roundings or overflow matter.
  double determinant = 0, size = 0, largest = 0;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3 &a = m[c], &b = m[(c + 1) % 3], &d = m[(c + 2) % 3];
    const double first = b.y * d.z, second = b.z * d.y;
    determinant += a.x * (first - second);
    size += std::abs(a.x) * (std::abs(first) + std::abs(second));
    largest = std::max({largest, std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  }
  if (largest < 1e90 && std::abs(determinant) > 1e-100 && std::abs(determinant) > 1e-12 * size)
    return true;
  Inverse inverse;
  return invert(m, inverse);
}

#define SIR_INSTANTIATE(T)                                        \
  template glm::vec<3, T> scaled_near_one(const glm::vec<3, T>&); \
  template bool invert(const glm::dmat3&, InverseIn<T>&);
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
