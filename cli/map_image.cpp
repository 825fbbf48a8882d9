#include "cli/map_image.h"

#include <functional>

#include "quant/nearest.h"
#include "quant/perceptual_search.h"

namespace sir::cli {

std::vector<std::uint8_t> map_image(const Planes& planes, const quant::Lut& lut,
                                    const MapOptions& options) {
  const bool by_eye = options.by == quant::Goal::perceptual;
  if (options.dither == quant::Dither::none)
    return by_eye ? quant::map_perceptually(planes, lut, options.reserved)
                  : quant::map_to_lut(planes, lut, quant::Mapping::exact, options.reserved);
  quant::NearestEntry nearest;
  if (by_eye) nearest = quant::PerceptualSearch(lut, options.reserved);
  else nearest = quant::NearestSearch(lut, options.reserved);
  return quant::dither(planes, lut, options.dither, nearest);
}

}  // namespace sir::cli
