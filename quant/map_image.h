// From an image to the LUT indices that are shown (thesis 3.5), as the options say.
#pragma once

#include <cstdint>
#include <vector>

#include "quant/colour_measure.h"
#include "quant/dither.h"
#include "quant/index_set.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

struct MapOptions {
  Goal by = Goal::psnr;  ///< what "nearest" means: by the bytes, or by the eye
  IndexSet reserved;     ///< entries that no pixel takes; not all
  Dither dither = Dither::none;
};

/// LUT indices, one a pixel, rows from the top. By default each is the nearest entry's
/// (map_to_lut); by the eye that of perceptually_nearest.
std::vector<std::uint8_t> map_image(const Planes& planes, const Lut& lut,
                                    const MapOptions& options);

}  // namespace sir::quant
