// From an image to the LUT indices that are shown (thesis 3.5), as the options say.
#pragma once

#include <cstdint>
#include <vector>

#include "quant/colour_measure.h"
#include "quant/dither.h"
#include "quant/index_set.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::cli {

struct MapOptions {
  quant::Goal by = quant::Goal::psnr;  ///< what "nearest" means: by the bytes, or by the eye
  quant::IndexSet reserved;            ///< entries that no pixel takes; not all
  quant::Dither dither = quant::Dither::none;
};

/// LUT indices, one a pixel, rows from the top. By default each is the nearest entry's
/// (quant::map_to_lut); by the eye that of quant::perceptually_nearest.
std::vector<std::uint8_t> map_image(const Planes& planes, const quant::Lut& lut,
                                    const MapOptions& options);

}  // namespace sir::cli
