// Dithering by place: a mixture of entries for each colour, picked from by blue noise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quant/known_entries.h"
#include "tracer/planes.h"

namespace sir::quant {

/// Entries that together average to a colour in linear light, the darkest first; repeated
/// where they weigh more.
inline constexpr std::size_t kMixed = 16;
using Mixture = std::array<std::uint8_t, kMixed>;

/// The mixture for a colour (after Knoll's pattern dithering, US patent 6606166 of 1999, expired):
/// entry after entry, each makes good the error that the one before it left
/// (KnownEntries::take). An entry's own colour gives that entry alone.
Mixture mixture_of(Rgb8 colour, KnownEntries& entries);

/// The image as LUT indices: the rank of the pixel's place in the mask of blue noise
/// (quant/blue_noise.h, from the image's top left corner) picks out of its colour's mixture.
/// Apart from flat areas a pixel depends on its own colour and place alone, so what does not
/// change from one image of a film to the next stands still. Pixels with `flat` set (one flag
/// a pixel) take the entry nearest to their colour.
std::vector<std::uint8_t> mixed_by_place(const Planes& image, std::span<const std::uint8_t> flat,
                                         KnownEntries& entries);

}  // namespace sir::quant
