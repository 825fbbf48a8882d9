#include "quant/provenance.h"

#include <algorithm>
#include <numeric>

namespace sir::quant {
namespace {

/// The way of a cell through the log: boxes that are split before it in the list move it on.
CutPath path_of(const GridPoint& cell, const CutLog& log, std::size_t& place) {
  CutPath path;
  place = 0;
  for (const BoxSplit& split : log.splits) {
    if (split.place > place) continue;
    if (split.place == place) {
      const bool upper = cell[split.axis] > split.last;
      path.splits.push_back({split, upper});
      if (!upper) continue;
    }
    ++place;
  }
  path.box = log.boxes[place];
  return path;
}

}  // namespace

Provenance::Provenance(const Planes& image, const ChooseOptions& options)
    : options_(options), grid_(grid_for(options)), cells_(count_for(image, options)) {
  lut_ = choose_from(cells_, options_, &log_);
  if (options_.method != Method::frequency || log_.each_cell_its_own) return;
  ranks_.resize(cells_.size());
  for (const PlaneChoice& plane : log_.planes) {
    std::vector<std::size_t> order(plane.cells);
    std::iota(order.begin(), order.end(), plane.first_cell);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return cells_[a].pixels > cells_[b].pixels;
    });
    for (std::size_t i = 0; i < order.size(); ++i) ranks_[order[i]] = i + 1;
    last_chosen_.push_back(plane.entries == 0 ? 0 : cells_[order[plane.entries - 1]].pixels);
  }
}

CellOrigin Provenance::of(Rgb8 colour) const {
  CellOrigin origin;
  origin.cell = grid_->point(grid_->cell(colour));
  origin.plane = grid_->plane(origin.cell);
  origin.grey = options_.space == Space::hsv && origin.plane == options_.grid.hues;
  const auto plane = std::find_if(log_.planes.begin(), log_.planes.end(),
                                  [&](const auto& one) { return one.plane == origin.plane; });
  if (plane == log_.planes.end()) return origin;
  origin.plane_cells = plane->cells;
  origin.plane_pixels = plane->pixels;
  origin.plane_entries = plane->entries;
  // The grid's order is that of the coordinates.
  const auto found =
      std::lower_bound(cells_.begin(), cells_.end(), origin.cell,
                       [](const Cell& cell, const GridPoint& at) { return cell.at < at; });
  if (found == cells_.end() || found->at != origin.cell) return origin;
  origin.pixels = found->pixels;
  const auto index = static_cast<std::size_t>(found - cells_.begin());
  if (log_.each_cell_its_own) {
    origin.how = OwnEntry{};
    origin.entry = index;
  } else if (options_.method == Method::frequency) {
    const std::size_t rank = ranks_[index];
    origin.how =
        FrequencyRank{rank, last_chosen_[static_cast<std::size_t>(plane - log_.planes.begin())]};
    if (rank <= plane->entries) origin.entry = plane->first_entry + rank - 1;
  } else if (plane->entries > 0) {
    std::size_t place = 0;
    origin.how = path_of(origin.cell, plane->cut, place);
    origin.entry = plane->first_entry + place;
  } else {
    origin.how = CutPath{};
  }
  return origin;
}

}  // namespace sir::quant
