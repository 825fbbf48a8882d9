#include "quant/psnr.h"

#include <cmath>

#include "quant/image_pair.h"

namespace sir::quant {

double mean_square_error(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  std::uint64_t sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t i = 0; i < reference.size.pixels(); ++i) {
      const int off = reference.channel[channel][i] - shown.channel[channel][i];
      sum += static_cast<std::uint64_t>(off * off);
    }
  return static_cast<double>(sum) / (3 * static_cast<double>(reference.size.pixels()));
}

std::optional<double> psnr(const Planes& reference, const Planes& shown) {
  const double error = mean_square_error(reference, shown);
  if (error == 0) return std::nullopt;
  return 10 * std::log10(255.0 * 255.0 / error);
}

}  // namespace sir::quant
