// Sums of products of doubles without rounding (Shewchuk, Adaptive Precision
// Floating-Point Arithmetic, 1997): for determinants, once a primitive (BASICO's
// initialisation, thesis 3.3).
#pragma once

#include <array>
#include <cstddef>

#include "tracer/double_double.h"
#include "tracer/numeric.h"

namespace sir {

/// Collects up to kParts/4 products of three numbers exactly, as a sum of
/// doubles that do not overlap. Exact while no product
/// overflows and none but zeros sinks below 2^-960.
class ExactSum {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const DoubleDouble sum = two_sum(term, part_[i]);
      if (sum.lo != 0) part_[kept++] = sum.lo;
      term = sum.hi;
    }
    if (term != 0) part_[kept++] = term;
    size_ = kept;
  }
  void add_product(double a, double b, double c = 1) {
    const DoubleDouble ab = two_product(a, b);
    for (const double factor : {ab.hi, ab.lo}) {
      const DoubleDouble abc = two_product(factor, c);
      add(abc.lo);
      add(abc.hi);
    }
  }

  bool is_zero() const { return size_ == 0; }
  /// Whether value() is surely the sum itself. T: double or wider.
  template <typename T>
  bool is_a() const {
    if (size_ <= 1) return true;
    if constexpr (!kWiderThanDouble<T>) return false;
    T sum = 0;
    for (std::size_t i = size_; i-- > 0;) {  // from the largest part down: fast_two_sum()
      const T next = sum + T(part_[i]);
      if (next - sum != T(part_[i])) return false;
      sum = next;
    }
    return true;
  }
  /// The sum, off by less than a unit in the last place.
  template <typename T>
  T value() const {
    T sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += T(part_[i]);
    return sum;
  }

 private:
  static constexpr std::size_t kParts = 32;
  std::array<double, kParts> part_;  // the first size_ are set
  std::size_t size_ = 0;
};

}  // namespace sir
