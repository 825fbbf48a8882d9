#include "quant/median_cut.h"

#include <algorithm>

namespace sir::quant {
namespace {

/// Some of the cells, by where they stand; splitting reorders within.
struct Box {
  std::span<Cell> cells;
  GridPoint low{}, high{};
  std::uint64_t pixels = 0;
  std::size_t axis = 0;  // the longest one
  int length = 0;        // greatest less least coordinate on it; 0 for a single cell

  CellBox summary() const { return {low, high, pixels, cells.size()}; }
};

Box shrunk_box(std::span<Cell> cells) {
  Box box{cells, cells.front().at, cells.front().at};
  for (const Cell& cell : cells) {
    box.pixels += cell.pixels;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], cell.at[axis]);
      box.high[axis] = std::max(box.high[axis], cell.at[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int length = box.high[axis] - box.low[axis];
    if (length > box.length) {
      box.axis = axis;
      box.length = length;
    }
  }
  return box;
}

/// The last coordinate of the lower half.
int median_coordinate(const Box& box) {
  std::vector<std::uint64_t> pixels(static_cast<std::size_t>(box.length) + 1);
  for (const Cell& cell : box.cells)
    pixels[static_cast<std::size_t>(cell.at[box.axis] - box.low[box.axis])] += cell.pixels;
  // The last coordinate is left out: the upper half must keep a cell. The
  // first one is occupied, as the box is shrunk.
  int best = 0;
  std::uint64_t best_miss = box.pixels, running = 0;
  for (int i = 0; i < box.length; ++i) {
    running += pixels[static_cast<std::size_t>(i)];
    const std::uint64_t twice = 2 * running;
    const std::uint64_t miss = twice > box.pixels ? twice - box.pixels : box.pixels - twice;
    if (miss < best_miss) {
      best_miss = miss;
      best = i;
    }
  }
  return box.low[box.axis] + best;
}

/// Boxes in the order in which they will stand in the LUT.
class BoxList {
 public:
  BoxList(std::span<Cell> cells, std::size_t wanted, CutLog* log) : wanted_(wanted), log_(log) {
    boxes_.reserve(wanted);
    boxes_.push_back(shrunk_box(cells));
  }

  bool complete() const { return boxes_.size() >= wanted_; }

  /// Splits the box with most of `key`, until complete or no box can be split.
  template <typename Key>
  void split_greatest(Key key) {
    while (!complete()) {
      std::size_t greatest = boxes_.size();
      for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (boxes_[i].length > 0 &&
            (greatest == boxes_.size() || key(boxes_[i]) > key(boxes_[greatest])))
          greatest = i;
      if (greatest == boxes_.size()) return;
      split(greatest);
    }
  }

  void split_rounds() {
    for (bool any = true; any && !complete();) {
      any = false;
      for (std::size_t i = 0; i < boxes_.size() && !complete(); ++i) {
        if (boxes_[i].length == 0) continue;
        split(i++);  // and past the upper half, which waits for the next round
        any = true;
      }
    }
  }

  const std::vector<Box>& boxes() const { return boxes_; }

 private:
  void split(std::size_t i) {
    const Box box = boxes_[i];
    const int last = median_coordinate(box);
    const auto middle = std::partition(box.cells.begin(), box.cells.end(),
                                       [&](const Cell& cell) { return cell.at[box.axis] <= last; });
    const auto lower = static_cast<std::size_t>(middle - box.cells.begin());
    boxes_[i] = shrunk_box(box.cells.first(lower));
    boxes_.insert(boxes_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  shrunk_box(box.cells.subspan(lower)));
    if (log_) log_->splits.push_back({i, box.summary(), box.axis, last, boxes_[i].pixels});
  }

  std::size_t wanted_;
  CutLog* log_;
  std::vector<Box> boxes_;
};

}  // namespace

std::vector<DacCode> median_cut(std::span<const Cell> cells, std::size_t entries, SplitOrder order,
                                const Grid& grid, CutLog* log) {
  if (cells.empty() || entries == 0) return {};
  std::vector<Cell> own(cells.begin(), cells.end());
  BoxList list(own, entries, log);
  switch (order) {
    case SplitOrder::pixels: list.split_greatest([](const Box& box) { return box.pixels; }); break;
    case SplitOrder::longest: list.split_greatest([](const Box& box) { return box.length; }); break;
    case SplitOrder::breadth: list.split_rounds(); break;
  }
  std::vector<DacCode> codes;
  for (const Box& box : list.boxes()) {
    PointSum mean;
    for (const Cell& cell : box.cells) mean.add(cell.at, cell.pixels);
    codes.push_back(grid.code(mean));
    if (log) log->boxes.push_back(box.summary());
  }
  return codes;
}

}  // namespace sir::quant
