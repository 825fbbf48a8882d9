// How often the colours of an image appear, cell by cell (thesis 3.4.1, 3.4.3 a-c).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quant/grid.h"
#include "tracer/planes.h"

namespace sir::quant {

/// A cell that is occupied, and by how many pixels (at least one).
struct Cell {
  GridPoint at{};
  std::uint64_t pixels = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The occupied cells of an image in the grid's order. Their number is the
/// thesis's "number of colours" of the image in that grid.
using Histogram = std::vector<Cell>;

/// Counts the pixels 0, `every`, 2 * `every`... of the image (3.4.1 samples
/// it); every pixel by default. Throws std::invalid_argument for every = 0.
Histogram count_cells(const Planes& image, const Grid& grid, std::size_t every = 1);

}  // namespace sir::quant
