// How different two images look from where single pixels are not told apart: what dither is for.
#pragma once

#include "tracer/planes.h"

namespace sir::quant {

/// The mean CIEDE2000 of two images after a Gaussian blur of both, in linear light: the eye mixes
/// light, not the bytes of sRGB. `sigma` in pixels; the Gaussian reaches ceil(4 sigma) pixels to
/// each side, and what of it lies outside of the image is left out and the rest made to add up to
/// 1 again, so an even image stays even up to its edges. The blurred colours are not rounded.
///
/// With 0 it is the mean of difference_map().
///
/// Throws std::invalid_argument for images of different sizes or without pixels, and for a sigma
/// that is negative or not finite.
double blurred_difference(const Planes& reference, const Planes& shown, double sigma = 1);

}  // namespace sir::quant
