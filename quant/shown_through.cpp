#include "quant/shown_through.h"

#include <array>
#include <stdexcept>

namespace sir::quant {

Planes as_seen(ImageSize size, std::span<const std::uint8_t> indices, const Lut& lut) {
  if (indices.size() != size.pixels())
    throw std::invalid_argument("there must be one LUT index a pixel");
  std::array<Rgb8, kLutEntries> colours;
  for (std::size_t i = 0; i < kLutEntries; ++i) colours[i] = lut.seen(i);
  Planes shown(size);
  for (std::size_t i = 0; i < indices.size(); ++i) shown.set(i, colours[indices[i]]);
  return shown;
}

Planes shown_through(const Planes& image, const Lut& lut, Mapping mapping) {
  return as_seen(image.size, map_to_lut(image, lut, mapping), lut);
}

}  // namespace sir::quant
