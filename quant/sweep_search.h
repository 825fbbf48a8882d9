// The nearest of a set of entries under a colour's own form, exactly.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/colour_measure.h"

namespace sir::quant {

/// Entries in the order of their first coordinate, x. A form has no mixed term with x, so what x
/// alone contributes is a lower bound of the whole: going outwards from the colour's own x, the
/// search ends on either side where that bound exceeds the least difference so far. Rounding does
/// not break this: what is added to xx dx^2 is never negative, and rounding is monotone. So the
/// answer is that of trying all entries, to the bit.
class SweepSearch {
 public:
  struct Nearest {
    std::uint32_t index = 0;
    float difference = std::numeric_limits<float>::infinity();
  };
  struct Two {
    Nearest first, second;
  };

  /// The points of the entries; an entry's index is its place here. With `left_out`, those
  /// indices are no answer.
  explicit SweepSearch(std::span<const glm::vec3> entries);

  /// The entry with the least form(at - entry); ties take the lowest index. At least one entry.
  Nearest nearest(const glm::vec3& at, const Form& form) const;

  /// That and the next one, of another index; infinitely far where there is one entry only.
  Two nearest_two(const glm::vec3& at, const Form& form) const;

 private:
  template <typename Keep>
  void sweep(const glm::vec3& at, const Form& form, Keep& keep) const;

  struct Entry {
    glm::vec3 at;
    std::uint32_t index;
  };
  std::vector<Entry> entries_;        // by x; one at -infinity and one at infinity around them
  std::vector<std::uint16_t> start_;  // by x in steps: the first entry not before
  float origin_ = 0, steps_ = 1;
};

}  // namespace sir::quant
