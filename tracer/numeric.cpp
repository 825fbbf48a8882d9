#include "tracer/numeric.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sir {
namespace {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Wide;
#else
using Wide = long double;
#endif

Wide magnitude(Wide x) { return x < 0 ? -x : x; }

// a + b = sum + error exactly (Knuth).
std::pair<double, double> two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// a * b = product + error exactly.
std::pair<double, double> two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

// A sum of doubles without rounding (Shewchuk's grow-expansion).
class ExactSum {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const auto [sum, error] = two_sum(term, part_[i]);
      if (error != 0) part_[kept++] = error;
      term = sum;
    }
    part_[kept++] = term;
    size_ = kept;
  }
  void add_product(double a, double b, double c) {
    const auto [high, low] = two_product(a, b);
    for (const double factor : {high, low}) {
      const auto [product, error] = two_product(factor, c);
      add(product);
      add(error);
    }
  }
  bool is_zero() const {
    return std::all_of(part_.begin(), part_.begin() + static_cast<std::ptrdiff_t>(size_),
                       [](double part) { return part == 0; });
  }

 private:
  std::array<double, 32> part_{};  // six products of four parts each, and room
  std::size_t size_ = 0;
};

// Numerators of a row that are to be divided by `divisor` and multiplied by
// 2^exponent: scaled by powers of two so that the divisor comes to lie in [1,2)
// and coordinates in SC_LOCAL have their natural size even before the division.
void set_divisor(Inverse& inverse, int row, double divisor, int exponent) {
  const int shift = -std::ilogb(divisor);
  inverse.divisors[row] = std::ldexp(divisor, shift);
  for (int c = 0; c < 3; ++c)
    inverse.numerators[c][row] = std::ldexp(inverse.numerators[c][row], shift + exponent);
}

bool fits(const Inverse& inverse) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!std::isfinite(inverse.numerators[c][r])) return false;
  return true;
}

// Cofactors over the determinant, where all of them are exact: entries that are
// integers of at most 16 bits times one power of two (the determinant then has
// 51).
bool invert_integers(const glm::dmat3& m, Inverse& inverse) {
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
  constexpr int kBits = 15;
  const int exponent = kBits - std::ilogb(largest);
  glm::dmat3 a(0.0);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      a[c][r] = std::ldexp(m[c][r], exponent);
      if (a[c][r] != std::trunc(a[c][r])) return false;
    }
  double determinant = 0;
  glm::dmat3 cofactor(0.0);  // [column][row] of the adjugate
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      const int c1 = (c + 1) % 3, c2 = (c + 2) % 3, r1 = (r + 1) % 3, r2 = (r + 2) % 3;
      cofactor[r][c] = a[c1][r1] * a[c2][r2] - a[c2][r1] * a[c1][r2];
    }
  for (int r = 0; r < 3; ++r) determinant += a[0][r] * cofactor[r][0];
  // a is the matrix times 2^exponent: its inverse is 2^exponent too small.
  const double sign = determinant < 0 ? -1 : 1;
  inverse.numerators = cofactor * sign;
  for (int row = 0; row < 3; ++row) set_divisor(inverse, row, sign * determinant, exponent);
  return true;
}

}  // namespace

glm::dvec3 scaled_near_one(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

bool is_singular(const glm::dmat3& m) {
  // Columns scaled by powers of two, so that the products neither overflow nor
  // underflow; the determinant keeps its zero.
  glm::dmat3 a(0.0);
  for (int c = 0; c < 3; ++c) {
    double largest = 0;
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
    if (largest == 0) return true;
    for (int r = 0; r < 3; ++r) a[c][r] = std::ldexp(m[c][r], -std::ilogb(largest));
  }
  ExactSum det;
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3, e = (c + 2) % 3;
    det.add_product(a[c][0], a[d][1], a[e][2]);
    det.add_product(-a[c][0], a[e][1], a[d][2]);
  }
  return det.is_zero();
}

bool invert(const glm::dmat3& m, Inverse& inverse) {
  if (is_singular(m)) return false;
  if (invert_integers(m, inverse)) return fits(inverse);
  std::array<std::array<Wide, 6>, 3> row{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      row[r][c] = m[static_cast<int>(c)][static_cast<int>(r)];
      row[r][c + 3] = r == c ? 1 : 0;
    }
  std::array<std::size_t, 3> column_of{};  // pivot column of each row
  std::array<bool, 3> row_done{}, column_done{};
  for (int step = 0; step < 3; ++step) {
    std::size_t pr = 0, pc = 0;
    Wide best = 0;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        if (!row_done[r] && !column_done[c] && magnitude(row[r][c]) > best) {
          best = magnitude(row[r][c]);
          pr = r;
          pc = c;
        }
    if (best == 0) return false;
    row_done[pr] = column_done[pc] = true;
    column_of[pr] = pc;
    const Wide pivot = row[pr][pc];
    for (Wide& x : row[pr]) x /= pivot;
    for (std::size_t r = 0; r < 3; ++r) {
      if (r == pr) continue;
      const Wide factor = row[r][pc];
      for (std::size_t c = 0; c < 6; ++c) row[r][c] -= factor * row[pr][c];
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    Wide largest = 0;
    for (std::size_t c = 3; c < 6; ++c) largest = std::max(largest, magnitude(row[r][c]));
    const int to = static_cast<int>(column_of[r]);
    for (std::size_t c = 0; c < 3; ++c)
      inverse.numerators[static_cast<int>(c)][to] = static_cast<double>(row[r][c + 3] / largest);
    const double divisor = static_cast<double>(1 / largest);
    if (divisor == 0 || !std::isfinite(divisor)) return false;
    set_divisor(inverse, to, divisor, 0);
  }
  return fits(inverse);
}

}  // namespace sir
