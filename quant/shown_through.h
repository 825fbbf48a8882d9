// An image as the monitor shows it through a LUT (thesis 3.5).
#pragma once

#include <cstdint>
#include <span>

#include "quant/lut.h"
#include "quant/nearest.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Indices, one a pixel, as the colours that their entries are seen as. Throws
/// std::invalid_argument where their number is not the size's.
Planes as_seen(ImageSize size, std::span<const std::uint8_t> indices, const Lut& lut);

/// Each pixel as its entry (map_to_lut) is seen: the nearest, unless told otherwise.
Planes shown_through(const Planes& image, const Lut& lut, Mapping mapping = Mapping::exact);

}  // namespace sir::quant
