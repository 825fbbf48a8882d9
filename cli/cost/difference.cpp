#include "cli/cost/difference.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "quant/ciede2000.h"
#include "quant/psnr.h"

namespace sir::cli {

std::size_t pixels_changed(const Planes& a, const Planes& b) {
  std::size_t changed = 0;
  for (std::size_t i = 0; i < a.size.pixels(); ++i) changed += !(a.at(i) == b.at(i));
  return changed;
}

Difference difference_between(const Planes& truth, const Planes& picture) {
  Difference difference;
  difference.psnr = quant::psnr(truth, picture);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < truth.size.pixels(); ++i)
      difference.largest =
          std::max(difference.largest, std::abs(truth.channel[c][i] - picture.channel[c][i]));
  const auto map = quant::difference_map(truth, picture);
  difference.de_mean =
      std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
  difference.pixels = pixels_changed(truth, picture);
  return difference;
}

double comparable(const std::optional<double>& psnr) {
  return psnr.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace sir::cli
