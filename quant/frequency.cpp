#include "quant/frequency.h"

#include <algorithm>

namespace sir::quant {

DacCode code_of(const Cell& cell, const Grid& grid) {
  PointSum itself;
  itself.add(cell.at, 1);
  return grid.code(itself);
}

std::vector<DacCode> most_frequent(std::span<const Cell> cells, std::size_t entries,
                                   const Grid& grid) {
  std::vector<const Cell*> order;
  order.reserve(cells.size());
  for (const Cell& cell : cells) order.push_back(&cell);
  const std::size_t chosen = std::min(entries, cells.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(chosen), order.end(),
                    [](const Cell* a, const Cell* b) {
                      if (a->pixels != b->pixels) return a->pixels > b->pixels;
                      return a < b;  // both point into `cells`: the one that stands first
                    });
  order.resize(chosen);
  std::vector<DacCode> codes;
  for (const Cell* const cell : order) codes.push_back(code_of(*cell, grid));
  return codes;
}

}  // namespace sir::quant
