// Choosing the LUT of an image: the thesis's four methods (thesis 3.4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "quant/grid.h"
#include "quant/histogram.h"
#include "quant/lut.h"
#include "quant/median_cut.h"
#include "tracer/planes.h"

namespace sir::quant {

enum class Method { frequency, median };
enum class Space { rgb, hsv };

struct ChooseOptions {
  Method method = Method::median;
  Space space = Space::hsv;
  SplitOrder split = SplitOrder::pixels;  ///< of median only
  HsvGridShape grid;                      ///< of the HSV space only
  int rgb_bits = RgbGrid::kBits;          ///< of the RGB space only: 1 to RgbGrid::kMaxBits
  std::size_t sample = 1;                 ///< every so many-th pixel is counted
};

/// The LUT of an image. Entries stand plane by plane, the grey plane last
/// (RGB is one plane); within a plane, the most frequent first or the boxes in
/// their order. An image of at most 256 occupied cells gets one entry for
/// each, in the grid's order.
/// Throws FileError for an image without pixels, std::invalid_argument for a
/// grid or a sample that cannot be.
Lut choose_lut(const Planes& image, const ChooseOptions& options = {});

/// The first half of choose_lut: counting in the grid of the space.
Histogram count_for(const Planes& image, const ChooseOptions& options);

/// What was done with one occupied plane of the grid.
struct PlaneChoice {
  int plane = 0;
  std::size_t first_cell = 0;   ///< index into the histogram
  std::size_t cells = 0;        ///< that many from there on
  std::uint64_t pixels = 0;     ///< in them
  std::size_t entries = 0;      ///< the plane's share of the LUT
  std::size_t first_entry = 0;  ///< where it begins in the LUT
  CutLog cut;                   ///< of median, unless every cell has its own entry
};

/// How a LUT came about, for those who want to know why.
struct ChoiceLog {
  bool each_cell_its_own = false;   ///< no more cells than entries: nothing was to be chosen
  std::vector<PlaneChoice> planes;  ///< in the grid's order
};

/// The second half: choosing from what was counted with the same options. `log`, if given,
/// receives what was done.
Lut choose_from(const Histogram& cells, const ChooseOptions& options, ChoiceLog* log = nullptr);

/// The grid of the space, of the shape that the options say.
std::unique_ptr<const Grid> grid_for(const ChooseOptions& options);

/// The number of colours (occupied cells) of an image in both grids.
struct CellCounts {
  std::size_t rgb = 0;
  std::size_t hsv = 0;  ///< the grey plane included
};
CellCounts occupied_cells(const Planes& image, const HsvGridShape& grid = {},
                          std::size_t sample = 1);

}  // namespace sir::quant
