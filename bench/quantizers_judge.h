// How good an image of 256 colours is, and what no choice of 256 colours of 6 bits a primary beats.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tracer/planes.h"

namespace sir::bench {

/// An image as shown against its reference.
struct Score {
  std::optional<double> psnr;     ///< decibels; none for equal images
  double mean = 0;                ///< CIEDE2000, over the pixels,
  double p95 = 0;                 ///< the least that 95 % of them do not exceed,
  std::optional<double> area;     ///< and the mean in the small coloured areas, where there are any
  std::optional<double> blurred;  ///< dither only: quant/blurred_difference.h
  std::optional<double> contours;  ///< dither only: quant/banding.h
};

/// `area` has a flag a pixel, or nothing.
Score judge(const Planes& reference, const Planes& shown, const std::vector<bool>& area,
            bool dithered);

/// Each pixel as the DAC's colour nearest in bytes: what is left where nothing but the 6 bits a
/// primary limits.
Planes on_the_lattice(const Planes& image);

/// Each pixel as the DAC's colour of least CIEDE2000, out of those up to two codes away from the
/// nearest in bytes, primary by primary.
Planes on_the_lattice_as_seen(const Planes& image);

/// The reference shown through the colours of `palette`, at most 256, rounded to 6 bits: each pixel
/// takes the nearest of the rounded ones. Throws std::runtime_error for more colours.
Planes through_rounded_palette(const Planes& reference, const Planes& palette);

/// The number of different colours.
std::size_t colours_of(const Planes& image);

}  // namespace sir::bench
