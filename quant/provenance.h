// Why a LUT's entry is what it is: the way from a colour through grid, allocation and boxes to
// the entry that the thesis's methods made for it (thesis 3.4.1 a-e, 3.4.3 a-e).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "quant/choose.h"
#include "quant/grid.h"
#include "quant/histogram.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// There were no more occupied cells than entries: the cell has one of its own.
struct OwnEntry {};

/// By frequency: where the cell stands among its plane's, the most frequent first.
struct FrequencyRank {
  std::size_t rank = 0;           ///< from 1 on; chosen if at most the plane's entries
  std::uint64_t last_chosen = 0;  ///< pixels of the last cell that was chosen; 0: none was
};

/// By median cut: a split of a box that held the cell, and the half that it went to. A plane
/// without entries has not been cut: no splits, and a box of nothing.
struct Descent {
  BoxSplit split;
  bool upper = false;
};
struct CutPath {
  std::vector<Descent> splits;  ///< from the plane's whole box down
  CellBox box;                  ///< that is split no more; the entry is the mean of its pixels
};

/// No pixel of the sample lies in the cell: nothing was made for it.
struct NotCounted {};

/// What became of a colour's cell.
struct CellOrigin {
  GridPoint cell{};
  bool grey = false;         ///< in the grey plane; of HSV only
  std::uint64_t pixels = 0;  ///< of the image in the cell, as sampled
  int plane = 0;             ///< hue, grey plane or, in RGB, 0
  std::size_t plane_cells = 0;
  std::uint64_t plane_pixels = 0;
  std::size_t plane_entries = 0;  ///< the plane's share of the LUT
  std::variant<NotCounted, OwnEntry, FrequencyRank, CutPath> how;
  /// The entry that was made out of the cell, alone or with others; none where the cell was not
  /// chosen. The pixels may be shown by another, which came nearer.
  std::optional<std::size_t> entry;
};

/// Chooses a LUT as choose_lut() does and remembers how. What it is asked is answered in
/// microseconds and may be asked by several threads at once.
class Provenance {
 public:
  /// Throws as choose_lut() does.
  Provenance(const Planes& image, const ChooseOptions& options);

  const ChooseOptions& options() const { return options_; }
  const Lut& lut() const { return lut_; }  ///< equal to choose_lut's

  CellOrigin of(Rgb8 colour) const;

 private:
  ChooseOptions options_;
  std::unique_ptr<const Grid> grid_;
  Histogram cells_;
  ChoiceLog log_;
  Lut lut_;
  std::vector<std::size_t> ranks_;          // of each cell within its plane; of frequency only
  std::vector<std::uint64_t> last_chosen_;  // of each plane; likewise
};

}  // namespace sir::quant
