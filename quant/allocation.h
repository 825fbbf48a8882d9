// Sharing the LUT's entries out among the planes of the grid (thesis 3.4.3 d, e).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sir::quant {

/// What a plane claims its share by.
struct PlaneClaim {
  std::size_t cells = 0;     ///< occupied cells
  std::uint64_t pixels = 0;  ///< breaks ties
};

/// The number of entries of each plane, by the method of largest remainders:
/// the floor of entries * cells / all cells, and one of what is left over to
/// each of the planes with the largest remainders (ties: more pixels, then
/// the plane that stands first). Adds up to `entries` where there are more
/// cells than that, and no plane gets more than it has cells; otherwise each
/// cell gets its entry.
std::vector<std::size_t> allocate(std::size_t entries, std::span<const PlaneClaim> planes);

}  // namespace sir::quant
