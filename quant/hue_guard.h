// Keeping the hues of a picture, the small ones too: what thesis 3.4.3 chooses colours in HSV for.
#pragma once

#include <span>
#include <vector>

#include "quant/colour_points.h"
#include "quant/dac_code.h"
#include "quant/palette.h"

namespace sir::quant {

/// The plane of a colour in the thesis's HSV grid: 0 to 35 for the hues of 10 degrees, 36 for grey.
int hue_plane(Rgb8 colour);

/// Raises the weight of colours in planes of less than 2 % of the whole weight, so that a small
/// coloured thing is not given up for a slight gain elsewhere, which the eye would not: by the
/// fourth root of what the plane lacks, but not above twice.
void raise_small_hues(std::span<ColourPoint> points);

/// Gives every plane that has colours an entry that is seen in it, and binds that entry to it by a
/// rule, so that no later step takes it away. A plane without an entry gets the code that serves
/// its colours best, in the place of the entry that is missed least and guards nothing. The
/// palette must be held. Planes of the greatest weight come first; returned are those for which
/// there is no entry left or that the DAC cannot show.
std::vector<int> guard_hues(Palette& palette, std::span<const WeightedColour> colours,
                            ColourMeasure& measure, const DacBits& dac);

}  // namespace sir::quant
