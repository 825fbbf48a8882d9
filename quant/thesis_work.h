// The choice of a LUT as a program of 1989 would have walked it: through the cells of boxes
// of the frequency matrix (thesis 3.4.1 a-e, 3.4.3). Slow on purpose; it counts its steps.
#pragma once

#include <cstdint>

#include "quant/choose.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Elementary work of one choice.
struct ThesisWork {
  std::uint64_t pixels_read = 0;    ///< pixels counted in the matrix
  std::uint64_t conversions = 0;    ///< RGB -> HSV; none in RGB
  std::uint64_t cells_visited = 0;  ///< cells of the matrix, and of a distribution along an axis
  friend bool operator==(const ThesisWork&, const ThesisWork&) = default;
};

struct WorkedLut {
  Lut lut;
  ThesisWork work;
};

/// Median cut over the dense matrix (32 x 32 x 32 in RGB; each hue's S x V and the grey
/// column in HSV). What a step visits:
///
/// - the matrix, every cell once, to find the colours present (3.4.3 c) and each plane's
///   limits; with 256 colours or fewer that is all;
/// - `shrink`: the limits r_min...b_max of a new box, those of the colours in it ("o subespaço
///   formado pelas cores da imagem"): every cell of the half that was cut off;
/// - a: subtractions only, no cell;  b: every cell of the box, for the distribution;
/// - c, d: the distribution, once to its end for the total, once up to the cut;
/// - e: no cell;  at the end every cell of each box, for its mean.
///
/// With `shrink` the LUT equals choose_lut()'s. Without it a box keeps the limits at which it
/// was cut, the matrix's own at first, and the LUT may differ from choose_lut()'s; an axis on
/// which all colours of a box have one coordinate is walked in vain, and the next longest taken.
///
/// Throws as choose_lut() does; std::invalid_argument for a method other than median.
WorkedLut choose_as_in_1989(const Planes& image, const ChooseOptions& options, bool shrink = true);

}  // namespace sir::quant
