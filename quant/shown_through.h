// An image as the monitor shows it through a LUT (thesis 3.5).
#pragma once

#include "quant/lut.h"
#include "quant/nearest.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Each pixel as its entry (map_to_lut) is seen: the nearest, unless told otherwise.
Planes shown_through(const Planes& image, const Lut& lut, Mapping mapping = Mapping::exact);

}  // namespace sir::quant
