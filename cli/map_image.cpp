#include "cli/map_image.h"

#include <functional>

#include "quant/nearest.h"

namespace sir::cli {

std::vector<std::uint8_t> map_image(const Planes& planes, const quant::Lut& lut,
                                    const MapOptions& options) {
  if (options.dither == quant::Dither::none) return quant::map_to_lut(planes, lut);
  quant::NearestSearch nearest(lut);
  return quant::dither(planes, lut, options.dither, std::ref(nearest));
}

}  // namespace sir::cli
