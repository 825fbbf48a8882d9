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
    for (int c = 0; c < 3; ++c) result.m[c][r] = std::ldexp(m[c][r], -result.row[r]);
  }
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3& v = result.m[c];
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return std::nullopt;
    result.column[c] = std::ilogb(largest);
    for (int r = 0; r < 3; ++r) result.m[c][r] = std::ldexp(v[r], -result.column[c]);
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

// The row's numerators are divided by `divisor`; scaled by powers of two so that
// it comes to lie in [1,2) and coordinates in SC_LOCAL have their natural size
// even before the division.
template <typename T>
void set_divisor(InverseIn<T>& inverse, int row, T divisor) {
  const int shift = -std::ilogb(divisor);
  const T sign = divisor < 0 ? T(-1) : T(1);
  inverse.divisors[row] = sign * std::ldexp(divisor, shift);
  for (int c = 0; c < 3; ++c)
    inverse.numerators[c][row] = sign * std::ldexp(inverse.numerators[c][row], shift);
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
  const ExactSum det = determinant(scaled->m);
  if (det.is_zero()) return false;

  bool all_exact = det.is_a<T>();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const ExactSum entry = cofactor(scaled->m, row, column);
      inverse.numerators[column][row] = entry.value<T>();
      all_exact = all_exact && entry.is_a<T>();
    }
  for (int row = 0; row < 3; ++row) {
    T divisor = det.value<T>();
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
      entry = std::ldexp(entry, exponent);
      if (!std::isfinite(entry)) return false;
      if (std::ldexp(entry, -exponent) != balanced_entry) inverse.exact[row] = false;
    }
  }
  return true;
}

#define SIR_INSTANTIATE(T)                                        \
  template glm::vec<3, T> scaled_near_one(const glm::vec<3, T>&); \
  template bool invert(const glm::dmat3&, InverseIn<T>&);
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
