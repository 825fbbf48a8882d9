#include "tracer/numeric.h"

#include <algorithm>
#include <optional>

#include "tracer/exact_sum.h"

namespace sir {
namespace {

// A matrix, its columns scaled by powers of two to near 1 so that products of
// three entries neither overflow nor underflow.
struct ScaledColumns {
  glm::dmat3 m{0.0};
  int exponent[3] = {};  // column c is m[c] times 2^exponent[c]
};

std::optional<ScaledColumns> scaled_columns(const glm::dmat3& m) {
  ScaledColumns scaled;
  for (int c = 0; c < 3; ++c) {
    double largest = 0;
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
    if (largest == 0) return std::nullopt;
    scaled.exponent[c] = std::ilogb(largest);
    for (int r = 0; r < 3; ++r) scaled.m[c][r] = std::ldexp(m[c][r], -scaled.exponent[c]);
  }
  return scaled;
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

// The row's numerators are divided by `divisor`; scaled by powers of two so that
// it comes to lie in [1,2) and coordinates in SC_LOCAL have their natural size
// even before the division.
void set_divisor(Inverse& inverse, int row, double divisor) {
  const int shift = -std::ilogb(divisor);
  const double sign = divisor < 0 ? -1 : 1;
  inverse.divisors[row] = sign * std::ldexp(divisor, shift);
  for (int c = 0; c < 3; ++c)
    inverse.numerators[c][row] = sign * std::ldexp(inverse.numerators[c][row], shift);
}

}  // namespace

glm::dvec3 scaled_near_one(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

bool is_singular(const glm::dmat3& m) {
  const auto scaled = scaled_columns(m);
  return !scaled || determinant(scaled->m).is_zero();
}

bool invert(const glm::dmat3& m, Inverse& inverse) {
  const auto scaled = scaled_columns(m);
  if (!scaled) return false;
  const ExactSum det = determinant(scaled->m);
  if (det.is_zero()) return false;

  bool all_exact = det.is_a_double();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const ExactSum entry = cofactor(scaled->m, row, column);
      inverse.numerators[column][row] = entry.value();
      all_exact = all_exact && entry.is_a_double();
    }
  for (int row = 0; row < 3; ++row) {
    double divisor = det.value();
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
      double& entry = inverse.numerators[column][row];
      entry = std::ldexp(entry, -scaled->exponent[row]);
      if (!std::isfinite(entry)) return false;
    }
  }
  return true;
}

}  // namespace sir
