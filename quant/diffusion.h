// Error diffusion (Floyd and Steinberg, Proceedings of the SID 17(2), 1976) in linear light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quant/known_entries.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The image as LUT indices. Pixel by pixel, the first row to the right, the next to the left and
/// so on (which keeps the worms of a single direction away): the colour wanted is the pixel's
/// own and the errors that came to it (KnownEntries::wanted); it takes the entry nearest to
/// that, and kErrorShare of what is left goes on, 7/16 to the next pixel of the row, and
/// 3/16, 5/16 and 1/16 to the row below, behind, straight and ahead.
///
/// A pixel of an entry's own colour takes that entry and hands on what came to it. Pixels with
/// `flat` set (one flag a pixel) take the entry nearest to their colour, no error, and pass
/// none. What would leave the image is lost.
std::vector<std::uint8_t> diffused(const Planes& image, std::span<const std::uint8_t> flat,
                                   KnownEntries& entries);

}  // namespace sir::quant
