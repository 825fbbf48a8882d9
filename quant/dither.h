// Dithering: a LUT's entries side by side, so that from a distance they mix to the colours
// between them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

enum class Dither : std::uint8_t {
  none,       ///< each pixel takes the entry nearest to it
  floyd,      ///< a pixel's error goes to its neighbours (quant/diffusion.h)
  blue_noise  ///< the pixel's place picks out of a mixture for its colour (quant/mixture.h)
};

/// The index of the LUT entry that is nearest to a colour, by whatever measure the caller maps:
/// a NearestSearch, for the thesis's. A colour that an entry is seen as must give such an entry.
using NearestEntry = std::function<std::uint8_t(Rgb8)>;

/// The image as indices of the LUT, one a pixel, rows from the top. Whatever the kind,
/// - flat areas (quant/flat_areas.h) take the entry nearest to their colour;
/// - a pixel of a colour that an entry is seen as takes that entry: an image of nothing but the
///   LUT's colours is shown exactly;
/// - `nearest` is asked once for each colour that is wanted anywhere;
/// - it is the same for the same input: one thread, no chance.
/// With Dither::none it is nearest(colour) everywhere.
std::vector<std::uint8_t> dither(const Planes& image, const Lut& lut, Dither kind,
                                 const NearestEntry& nearest);

}  // namespace sir::quant
