// Error diffusion (Floyd and Steinberg, Proceedings of the SID 17(2), 1976) in linear light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quant/known_entries.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The image as LUT indices, pixel by pixel, the first row to the right, the next to the left and
/// so on (which keeps the worms of a single direction away). A pixel makes good the error that
/// came to it (KnownEntries::take); of what is left then, 7/16 go to the next pixel of the row and
/// 3/16, 5/16 and 1/16 to the row below, behind, straight and ahead. What would leave the
/// image is lost.
///
/// Pixels with `flat` set (one flag a pixel) take the entry nearest to their colour, no error, and
/// pass none.
std::vector<std::uint8_t> diffused(const Planes& image, std::span<const std::uint8_t> flat,
                                   KnownEntries& entries);

}  // namespace sir::quant
