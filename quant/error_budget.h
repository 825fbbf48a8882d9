// Where the error of an image shown through a LUT comes from.
#pragma once

#include <span>
#include <vector>

#include "quant/ciede2000.h"
#include "quant/color_space.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Three steps from the image to what is shown; the error after each is that
/// of an image with each pixel as
/// 1. the best of the unrounded colours,
/// 2. the best of the entries as seen, which are those rounded to the bits of the LUT's DAC,
/// 3. the entry that the monitor shows: the nearest in bytes (shown_through).
/// A step's part is what it adds, so the parts make up the total.
struct ErrorBudget {
  double total = 0;
  double entries = 0;  ///< step 1: there are no more colours than these
  double dac = 0;      ///< step 2; below 0 where rounding happens to do good
  double mapping = 0;  ///< step 3: never below 0
};

/// The budget of the mean CIEDE2000, which also says what is best in steps 1
/// and 2. `unrounded` are the LUT's colours before rounding, in any order.
/// Throws std::invalid_argument for an image without pixels, and where there is no colour.
ErrorBudget error_budget(const Planes& reference, const Lut& lut, std::span<const Rgb> unrounded);

/// The same with unrounded_colours().
ErrorBudget error_budget(const Planes& reference, const Lut& lut);

/// The budget of the mean square error of the bytes, best being what is
/// nearest in bytes: nothing is then left for the mapping, it is 0.
ErrorBudget square_error_budget(const Planes& reference, const Lut& lut,
                                std::span<const Rgb> unrounded);
ErrorBudget square_error_budget(const Planes& reference, const Lut& lut);

/// What the different entries of a LUT may have been before rounding, however
/// they were chosen: out of all colours that become the entry's code, the one
/// nearest to the mean of the pixels that it shows; e / 63 (of a DAC of 6 bits)
/// for an entry that shows none. So no more is laid to the DAC than rounding can have done, and
/// the square error's `dac` is never below 0. In the entries' order.
std::vector<Rgb> unrounded_colours(const Planes& reference, const Lut& lut);

/// Finds the least CIEDE2000 between a colour and some others.
class LeastDifference {
 public:
  explicit LeastDifference(std::vector<Lab> colours);
  double operator()(const Lab& colour) const;

 private:
  std::vector<Lab> by_lightness_;
};

}  // namespace sir::quant
