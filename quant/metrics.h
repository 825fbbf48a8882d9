// What a LUT does to an image, in numbers.
#pragma once

#include <cstddef>
#include <optional>

#include "tracer/planes.h"

namespace sir::quant {

/// An image as shown against its reference.
struct ImageMetrics {
  std::optional<double> psnr;  ///< decibels (quant/psnr.h); none for equal images
  double rmse = 0;             ///< root mean square error of the bytes
  double de_mean = 0;          ///< CIEDE2000 over the pixels (quant/ciede2000.h): mean,
  double de_p95 = 0;           ///< the least that 95 % of them do not exceed,
  double de_max = 0;           ///< and the greatest
  double ssim = 1;             ///< quant/ssim.h
  std::size_t colours = 0;     ///< different ones in the shown image
  double banding = 0;          ///< quant/banding.h
  double hue_loss = 0;         ///< quant/hue_loss.h, over all hues
};

/// Throws std::invalid_argument for images of different sizes or without pixels.
ImageMetrics measure(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
