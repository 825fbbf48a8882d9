#include "quant/map_image.h"

#include <functional>

#include "quant/nearest.h"
#include "quant/perceptual_search.h"

namespace sir::quant {

std::vector<std::uint8_t> map_image(const Planes& planes, const Lut& lut,
                                    const MapOptions& options) {
  const bool by_eye = options.by == Goal::perceptual;
  if (options.dither == Dither::none)
    return by_eye ? map_perceptually(planes, lut, options.reserved)
                  : map_to_lut(planes, lut, Mapping::exact, options.reserved);
  NearestEntry nearest;
  if (by_eye) nearest = PerceptualSearch(lut, options.reserved);
  else nearest = NearestSearch(lut, options.reserved);
  return dither(planes, lut, options.dither, nearest);
}

}  // namespace sir::quant
