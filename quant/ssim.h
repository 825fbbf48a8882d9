// Structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004).
#pragma once

#include "tracer/planes.h"

namespace sir::quant {

/// The mean over the three planes of the mean SSIM of all windows of 7x7
/// pixels that lie within the image, all pixels of a window counting alike;
/// variances are divided by 48, K1 = 0.01, K2 = 0.03, range 255. These are the
/// defaults of scikit-image's structural_similarity with data_range=255 and
/// channel_axis. 1 for equal images.
///
/// An image narrower or lower than 7 pixels has windows as wide or as high as
/// itself; those of a single pixel have no variance.
/// Throws std::invalid_argument for images of different sizes or without pixels.
double ssim(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
