// The nearest of a set of entries under a colour's own form, exactly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/colour_measure.h"

namespace sir::quant {

/// Entries in the order of their first coordinate, x, in rows of eight. A form has no mixed term
/// with x, so what x alone contributes is a lower bound of the whole: going from the colour's own
/// x outwards, row by row, the search ends on either side where that bound exceeds the least
/// difference so far. Rounding does not break this: what is added to xx dx^2 is never negative,
/// and rounding is monotone. So the answer is that of trying all entries, to the bit.
class SweepSearch {
 public:
  struct Nearest {
    std::uint32_t index = 0;
    float difference = std::numeric_limits<float>::infinity();
  };

  /// The points of the entries, at least one; an entry's index is its place here.
  explicit SweepSearch(std::span<const glm::vec3> entries);

  /// The entry with the least form(at - entry); ties take the lowest index.
  Nearest nearest(const glm::vec3& at, const Form& form) const;

 private:
  static constexpr std::size_t kLanes = 8, kSteps = 1024;

  struct Row {
    std::array<float, kLanes> x, y, z;
    std::array<std::uint32_t, kLanes> index;
  };
  void look(const Row& row, const glm::vec3& at, const Form& form, Nearest& nearest) const;

  std::vector<Row> rows_;                    // by x; the last one is filled up with its last entry
  std::vector<float> low_, high_;            // x of each row's ends; infinitely far beyond them
  std::array<std::uint16_t, kSteps> start_;  // for each of even steps of x, the row to begin with
  float origin_ = 0, steps_ = 0;
};

}  // namespace sir::quant
