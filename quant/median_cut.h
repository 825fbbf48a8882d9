// Selection of colours by median cut (thesis 3.4.1 a-e; Heckbert 1982).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quant/grid.h"
#include "quant/histogram.h"

namespace sir::quant {

/// Which box is split next; the thesis leaves it open. Boxes of a single cell
/// are never split.
enum class SplitOrder {
  pixels,   ///< the box with most pixels (ties: the one that stands first)
  breadth,  ///< every box of the list in its order, round after round
  longest   ///< the box with the longest axis (ties: the one that stands first)
};

/// A box, shrunk to the cells present, and what is in it.
struct CellBox {
  GridPoint low{}, high{};  ///< both included
  std::uint64_t pixels = 0;
  std::size_t cells = 0;
  friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// One split: the halves stand at `place` and `place + 1` of the list then, lower first.
struct BoxSplit {
  std::size_t place = 0;  ///< of the box in the list
  CellBox box;
  std::size_t axis = 0;
  int last = 0;  ///< the last coordinate of the lower half
  std::uint64_t lower_pixels = 0;
  friend bool operator==(const BoxSplit&, const BoxSplit&) = default;
};

/// How the boxes came about, for those who want to know why.
struct CutLog {
  std::vector<BoxSplit> splits;  ///< in their order
  std::vector<CellBox> boxes;    ///< the last ones, in the list's order
};

/// Splits the box of all `cells` until there are `entries` boxes, or only
/// boxes of a single cell, and returns the boxes' means in the list's order.
///
/// A box is shrunk to the cells present. It is split along its longest axis
/// (ties: the first axis), after the coordinate where the running total of
/// pixels is nearest to half (ties: the lower), so that both halves are
/// occupied; they take the box's place in the list, lower first.
///
/// `cells` are one plane's, in any order: the result does not depend on it. `log`, if given,
/// receives what was done.
std::vector<DacCode> median_cut(std::span<const Cell> cells, std::size_t entries, SplitOrder order,
                                const Grid& grid, CutLog* log = nullptr);

}  // namespace sir::quant
