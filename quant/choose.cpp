#include "quant/choose.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "quant/allocation.h"
#include "quant/frequency.h"
#include "tracer/error.h"

namespace sir::quant {
namespace {

/// The cells of each occupied plane; they stand together in the grid's order.
std::vector<std::span<const Cell>> planes_of(const Histogram& cells, const Grid& grid) {
  std::vector<std::span<const Cell>> planes;
  for (std::size_t first = 0; first < cells.size();) {
    std::size_t end = first;
    while (end < cells.size() && grid.plane(cells[end].at) == grid.plane(cells[first].at)) ++end;
    planes.push_back(std::span(cells).subspan(first, end - first));
    first = end;
  }
  return planes;
}

/// The colours plane by plane; how, in `log`.
std::vector<DacCode> shared_out(const Histogram& cells, const ChooseOptions& options,
                                const Grid& grid, ChoiceLog* log) {
  const auto planes = planes_of(cells, grid);
  std::vector<PlaneClaim> claims;
  for (const auto plane : planes) {
    claims.push_back({plane.size(), 0});
    for (const Cell& cell : plane) claims.back().pixels += cell.pixels;
  }
  const auto shares = allocate(kLutEntries, claims);
  const bool each_its_own = cells.size() <= kLutEntries;
  if (log) *log = {each_its_own, {}};
  std::vector<DacCode> colours;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    CutLog* cut = nullptr;
    if (log) {
      log->planes.push_back({grid.plane(planes[i].front().at),
                             static_cast<std::size_t>(planes[i].data() - cells.data()),
                             planes[i].size(),
                             claims[i].pixels,
                             shares[i],
                             colours.size(),
                             {}});
      cut = &log->planes.back().cut;
    }
    if (each_its_own) {
      for (const Cell& cell : planes[i]) colours.push_back(code_of(cell, grid));
      continue;
    }
    const auto chosen = options.method == Method::frequency
                            ? most_frequent(planes[i], shares[i], grid)
                            : median_cut(planes[i], shares[i], options.split, grid, cut);
    colours.insert(colours.end(), chosen.begin(), chosen.end());
  }
  return colours;
}

}  // namespace

Histogram count_for(const Planes& image, const ChooseOptions& options) {
  return count_cells(image, *grid_for(options), options.sample);
}

Lut choose_from(const Histogram& cells, const ChooseOptions& options, ChoiceLog* log) {
  if (cells.empty()) throw FileError("image", 0, "has no pixels to choose colours from");
  return make_lut(shared_out(cells, options, *grid_for(options), log));
}

std::unique_ptr<const Grid> grid_for(const ChooseOptions& options) {
  if (options.space == Space::rgb) return std::make_unique<RgbGrid>(options.rgb_bits);
  return std::make_unique<HsvGrid>(options.grid);
}

Lut choose_lut(const Planes& image, const ChooseOptions& options) {
  return choose_from(count_for(image, options), options);
}

CellCounts occupied_cells(const Planes& image, const HsvGridShape& grid, std::size_t sample) {
  return {count_cells(image, RgbGrid(), sample).size(),
          count_cells(image, HsvGrid(grid), sample).size()};
}

}  // namespace sir::quant
