// From pixels to LUT indices by way of a lattice: all but the nearest entry, for
// pricing the exact search of thesis 3.5 (see Mapping in quant/nearest.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quant/index_set.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The inverse colour map of the quantising programs (Heckbert, SIGGRAPH 1982; Thomas,
/// Graphics Gems II, 1991): the cube of colours in 32 x 32 x 32 cells of 8 levels a side,
/// each with the entry that is nearest to its centre, which lies half-way between two
/// levels on every axis; ties take the lowest index. A cell is worked out when its first
/// colour comes.
///
/// A colour is within h = 3.5 sqrt(3) of its cell's centre m. With n its nearest entry
/// and e its cell's, |c-e| <= |c-m| + |m-e| <= |c-m| + |m-n| <= 2|c-m| + |c-n|: an answer
/// is at most kWorst = 2h, the cell's diagonal, farther off than the exact one.
class InverseMap {
 public:
  static constexpr int kCellBits = 3;                     ///< 8 levels a side
  static constexpr double kWorst = 12.12435565298214106;  ///< 7 sqrt(3) levels

  /// Cells take no entry that is reserved. Throws std::invalid_argument where all are.
  explicit InverseMap(const Lut& lut, const IndexSet& reserved = {});

  /// The index of the entry that its cell's centre is nearest to.
  std::uint8_t operator()(Rgb8 colour) {
    std::int16_t& index = cells_[cell_of(colour)];
    if (index < 0) index = nearest_to_centre(colour);
    return static_cast<std::uint8_t>(index);
  }

 private:
  static std::size_t cell_of(Rgb8 colour) {
    constexpr int kSideBits = 8 - kCellBits;
    return static_cast<std::size_t>(((colour.r >> kCellBits) << 2 * kSideBits) +
                                    ((colour.g >> kCellBits) << kSideBits) +
                                    (colour.b >> kCellBits));
  }
  std::int16_t nearest_to_centre(Rgb8 colour) const;

  struct Entry {
    Rgb8 colour;
    std::int16_t index;
  };
  std::vector<Entry> entries_;       // those that may be taken, the last chosen colour once
  std::vector<std::int16_t> cells_;  // -1: no colour of it yet
};

}  // namespace sir::quant
