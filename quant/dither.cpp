#include "quant/dither.h"

#include "quant/diffusion.h"
#include "quant/flat_areas.h"
#include "quant/known_entries.h"
#include "quant/mixture.h"

namespace sir::quant {

std::vector<std::uint8_t> dither(const Planes& image, const Lut& lut, Dither kind,
                                 const NearestEntry& nearest) {
  KnownEntries entries(lut, nearest);
  if (kind == Dither::floyd) return diffused(image, flat_areas(image), entries);
  if (kind == Dither::blue_noise) return mixed_by_place(image, flat_areas(image), entries);
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = entries.nearest(image.at(i));
  return indices;
}

}  // namespace sir::quant
