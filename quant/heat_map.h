// Where an image is shown wrong, as an image.
#pragma once

#include "tracer/planes.h"

namespace sir::quant {

/// The CIEDE2000 that is shown in white, and any greater one.
inline constexpr double kWhiteHot = 10;

/// The colour of a CIEDE2000: black 0, a violet blue 2.5, red 5, yellow 7.5, white
/// kWhiteHot, straight in bytes between; its lightness grows all the way, so
/// brighter is worse. Takes difference >= 0.
Rgb8 heat_colour(double difference);

/// heat_colour of each pixel's CIEDE2000. Throws std::invalid_argument for
/// images of different sizes or without pixels.
Planes heat_map(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
