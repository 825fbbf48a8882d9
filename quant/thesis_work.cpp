#include "quant/thesis_work.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include "quant/allocation.h"
#include "quant/frequency.h"
#include "quant/grid.h"
#include "tracer/error.h"

namespace sir::quant {
namespace {

/// Cells low to high of the grid, both included, and the pixels in them.
struct Box {
  GridPoint low{}, high{};
  std::uint64_t pixels = 0;
  std::size_t cells = 0;  // occupied ones

  int length(std::size_t axis) const { return high[axis] - low[axis]; }
  int longest() const { return std::max({length(0), length(1), length(2)}); }
};

/// The frequency matrix, its cells counted as they are visited.
class Matrix {
 public:
  Matrix(const Planes& image, const ChooseOptions& options, ThesisWork& work)
      : rgb_(options.space == Space::rgb), shape_(options.grid), work_(work) {
    if (options.sample == 0) throw std::invalid_argument("a sample of every 0th pixel");
    if (rgb_) grid_ = std::make_unique<RgbGrid>();
    else grid_ = std::make_unique<HsvGrid>(shape_);
    pixels_.resize(grid_->size());
    for (std::size_t i = 0; i < image.size.pixels(); i += options.sample) {
      ++pixels_[grid_->cell(image.at(i))];
      ++work_.pixels_read;
      if (!rgb_) ++work_.conversions;
    }
  }

  const Grid& grid() const { return *grid_; }

  /// The planes, each as one box of all its cells.
  std::vector<Box> planes() const {
    constexpr int kLast = RgbGrid::kLevels - 1;
    if (rgb_) return {{{0, 0, 0}, {kLast, kLast, kLast}}};
    std::vector<Box> planes;
    const int s = shape_.saturations - 1, v = shape_.values - 1;
    for (int h = 0; h < shape_.hues; ++h) planes.push_back({{h, 0, 0}, {h, s, v}});
    planes.push_back({{shape_.hues, 0, 0}, {shape_.hues, 0, v}});
    return planes;
  }

  /// Calls seen(point, pixels) for every occupied cell of a box, in the grid's order.
  template <typename Seen>
  void walk(const Box& box, Seen seen) const {
    GridPoint at;
    for (at[0] = box.low[0]; at[0] <= box.high[0]; ++at[0])
      for (at[1] = box.low[1]; at[1] <= box.high[1]; ++at[1])
        for (at[2] = box.low[2]; at[2] <= box.high[2]; ++at[2]) {
          ++work_.cells_visited;
          if (const std::uint64_t pixels = pixels_[index(at)]; pixels > 0) seen(at, pixels);
        }
  }

 private:
  std::size_t index(const GridPoint& at) const {
    const int number = rgb_ ? (at[0] * RgbGrid::kLevels + at[1]) * RgbGrid::kLevels + at[2]
                            : (at[0] * shape_.saturations + at[1]) * shape_.values +
                                  at[2];  // the grey's: at[1] = 0
    return static_cast<std::size_t>(number);
  }

  bool rgb_;
  HsvGridShape shape_;
  ThesisWork& work_;
  std::unique_ptr<const Grid> grid_;
  std::vector<std::uint64_t> pixels_;
};

/// Counts what is in a box and shrinks it to that; calls seen(point) for each colour.
template <typename Seen>
Box shrunk(const Box& box, const Matrix& matrix, Seen seen) {
  Box found{box.high, box.low};
  matrix.walk(box, [&](const GridPoint& at, std::uint64_t pixels) {
    seen(at);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      found.low[axis] = std::min(found.low[axis], at[axis]);
      found.high[axis] = std::max(found.high[axis], at[axis]);
    }
    found.pixels += pixels;
    ++found.cells;
  });
  return found;
}

/// Steps a-e on the boxes of one plane.
class Cutter {
 public:
  Cutter(const Box& plane, const Matrix& matrix, bool shrink, ThesisWork& work)
      : matrix_(matrix), shrink_(shrink), work_(work), boxes_{plane} {}

  void cut(std::size_t wanted, SplitOrder order) {
    if (order == SplitOrder::breadth) return cut_rounds(wanted);
    const auto key = [&](const Box& box) {
      return order == SplitOrder::pixels ? box.pixels : static_cast<std::uint64_t>(box.longest());
    };
    while (boxes_.size() < wanted) {
      std::size_t greatest = boxes_.size();
      for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (boxes_[i].cells > 1 &&
            (greatest == boxes_.size() || key(boxes_[i]) > key(boxes_[greatest])))
          greatest = i;
      if (greatest == boxes_.size()) return;
      split(greatest);
    }
  }

  std::vector<DacCode> means() const {
    std::vector<DacCode> codes;
    for (const Box& box : boxes_) {
      PointSum mean;
      matrix_.walk(box, [&](const GridPoint& at, std::uint64_t pixels) { mean.add(at, pixels); });
      codes.push_back(matrix_.grid().code(mean));
    }
    return codes;
  }

 private:
  struct Place {
    std::uint64_t pixels = 0;
    std::size_t cells = 0;
    Place& operator+=(const Place& other) {
      pixels += other.pixels;
      cells += other.cells;
      return *this;
    }
  };
  using Distribution = std::vector<Place>;

  void cut_rounds(std::size_t wanted) {
    for (bool any = true; any && boxes_.size() < wanted;) {
      any = false;
      for (std::size_t i = 0; i < boxes_.size() && boxes_.size() < wanted; ++i) {
        if (boxes_[i].cells < 2) continue;
        split(i++);
        any = true;
      }
    }
  }

  Distribution distribution(const Box& box, std::size_t axis) const {
    Distribution places(static_cast<std::size_t>(box.length(axis)) + 1);
    matrix_.walk(box, [&](const GridPoint& at, std::uint64_t pixels) {
      Place& place = places[static_cast<std::size_t>(at[axis] - box.low[axis])];
      place.pixels += pixels;
      ++place.cells;
    });
    return places;
  }

  /// The last place of the lower half: where the running total is nearest to half, both
  /// halves occupied; what they hold is written into them. False where one place holds all.
  bool median(const Distribution& places, std::size_t& cut, Box& lower, Box& upper) {
    Place total;
    for (const Place& place : places) total += place;
    work_.cells_visited += places.size();  // step c
    Place running;
    std::uint64_t best_miss = total.pixels;  // as if nothing were cut off
    for (std::size_t i = 0; i < places.size(); ++i) {
      running += places[i];
      const std::uint64_t twice = 2 * running.pixels;
      const std::uint64_t miss = twice > total.pixels ? twice - total.pixels : total.pixels - twice;
      if (miss >= best_miss) continue;
      best_miss = miss;
      cut = i;
      lower.pixels = running.pixels;
      lower.cells = running.cells;
      upper.pixels = total.pixels - running.pixels;
      upper.cells = total.cells - running.cells;
    }
    const bool found = best_miss < total.pixels;
    work_.cells_visited += found ? cut + 1 : places.size();  // step d
    return found;
  }

  void split(std::size_t i) {
    const Box box = boxes_[i];
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](std::size_t a, std::size_t b) { return box.length(a) > box.length(b); });
    // Two cells differ on some axis, so one of them can be cut; the longest where boxes are shrunk.
    Box lower = box, upper = box;
    for (const std::size_t axis : axes) {
      std::size_t cut = 0;
      if (!median(distribution(box, axis), cut, lower, upper)) continue;
      lower.high[axis] = box.low[axis] + static_cast<int>(cut);
      upper.low[axis] = lower.high[axis] + 1;
      break;
    }
    if (shrink_) {
      const auto ignore = [](const GridPoint&) {};
      lower = shrunk(lower, matrix_, ignore);
      upper = shrunk(upper, matrix_, ignore);
    }
    boxes_[i] = lower;
    boxes_.insert(boxes_.begin() + static_cast<std::ptrdiff_t>(i) + 1, upper);
  }

  const Matrix& matrix_;
  bool shrink_;
  ThesisWork& work_;
  std::vector<Box> boxes_;
};

}  // namespace

WorkedLut choose_as_in_1989(const Planes& image, const ChooseOptions& options, bool shrink) {
  if (options.method != Method::median)
    throw std::invalid_argument("the work of 1989 is known for the median cut only");
  WorkedLut result;
  const Matrix matrix(image, options, result.work);
  std::vector<Box> planes;
  std::vector<PlaneClaim> claims;
  std::vector<DacCode> tones;
  for (const Box& plane : matrix.planes()) {
    Box box = shrunk(plane, matrix, [&](const GridPoint& at) {
      if (tones.size() <= kLutEntries) tones.push_back(code_of({at, 1}, matrix.grid()));
    });
    if (box.cells == 0) continue;
    if (!shrink) {
      box.low = plane.low;
      box.high = plane.high;
    }
    planes.push_back(box);
    claims.push_back({box.cells, box.pixels});
  }
  if (planes.empty()) throw FileError("image", 0, "has no pixels to choose colours from");
  if (tones.size() > kLutEntries) {
    tones.clear();
    const auto shares = allocate(kLutEntries, claims);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (shares[i] == 0) continue;
      Cutter cutter(planes[i], matrix, shrink, result.work);
      cutter.cut(shares[i], options.split);
      const auto means = cutter.means();
      tones.insert(tones.end(), means.begin(), means.end());
    }
  }
  result.lut = make_lut(tones);
  return result;
}

}  // namespace sir::quant
