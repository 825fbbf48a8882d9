// An image as the monitor shows it through a LUT (thesis 3.5).
#pragma once

#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Each pixel as its nearest entry (map_to_lut) is seen.
Planes shown_through(const Planes& image, const Lut& lut);

}  // namespace sir::quant
