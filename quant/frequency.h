// Selection of colours by absolute frequency (thesis 3.4.1; Heckbert 1982).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quant/grid.h"
#include "quant/histogram.h"

namespace sir::quant {

/// The codes of the `entries` most frequent of `cells` (fewer where there are
/// fewer cells), the most frequent first; ties: the cell that stands first.
std::vector<DacCode> most_frequent(std::span<const Cell> cells, std::size_t entries,
                                   const Grid& grid);

/// The code of a single cell.
DacCode code_of(const Cell& cell, const Grid& grid);

}  // namespace sir::quant
