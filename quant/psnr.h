// How far an image's bytes are off: root mean square error and PSNR.
#pragma once

#include <optional>

#include "tracer/planes.h"

namespace sir::quant {

/// The mean of the squared differences of all bytes of the three planes.
/// Both throw std::invalid_argument for images of different sizes or without
/// pixels.
double mean_square_error(const Planes& reference, const Planes& shown);

/// Peak signal-to-noise ratio, 10 log10(255^2 / mean square error), in
/// decibels; none for equal images, where it has no bound.
std::optional<double> psnr(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
