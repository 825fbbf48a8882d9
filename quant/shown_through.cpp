#include "quant/shown_through.h"

namespace sir::quant {

Planes shown_through(const Planes& image, const Lut& lut, Mapping mapping) {
  const auto indices = map_to_lut(image, lut, mapping);
  Planes shown(image.size);
  for (std::size_t i = 0; i < indices.size(); ++i) shown.set(i, seen(lut.entry[indices[i]]));
  return shown;
}

}  // namespace sir::quant
