#include "quant/metrics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quant/banding.h"
#include "quant/ciede2000.h"
#include "quant/hue_loss.h"
#include "quant/image_pair.h"
#include "quant/psnr.h"
#include "quant/ssim.h"

namespace sir::quant {

ImageMetrics measure(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  ImageMetrics metrics;
  metrics.psnr = psnr(reference, shown);
  metrics.rmse = std::sqrt(mean_square_error(reference, shown));

  auto differences = difference_map(reference, shown);
  const std::size_t pixels = differences.size();
  metrics.de_mean =
      std::accumulate(differences.begin(), differences.end(), 0.0) / static_cast<double>(pixels);
  const auto p95 = differences.begin() + static_cast<std::ptrdiff_t>((95 * pixels + 99) / 100 - 1);
  std::nth_element(differences.begin(), p95, differences.end());
  metrics.de_p95 = *p95;
  metrics.de_max = *std::max_element(p95, differences.end());

  metrics.ssim = ssim(reference, shown);
  metrics.colours = distinct_colours(shown).size();
  metrics.banding = banding(reference, shown);
  metrics.hue_loss = hue_loss(reference, shown).weighted;
  return metrics;
}

}  // namespace sir::quant
