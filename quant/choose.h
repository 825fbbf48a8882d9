// Choosing the LUT of an image: the thesis's four methods (thesis 3.4).
#pragma once

#include <cstddef>

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

/// The second half: choosing from what was counted with the same options.
Lut choose_from(const Histogram& cells, const ChooseOptions& options);

/// The number of colours (occupied cells) of an image in both grids.
struct CellCounts {
  std::size_t rgb = 0;
  std::size_t hsv = 0;  ///< the grey plane included
};
CellCounts occupied_cells(const Planes& image, const HsvGridShape& grid = {},
                          std::size_t sample = 1);

}  // namespace sir::quant
