#include "quant/diffusion.h"

#include <algorithm>
#include <cstddef>

namespace sir::quant {
namespace {

void add(Light& to, const Light& error, double weight) {
  for (std::size_t k = 0; k < 3; ++k) to[k] += weight * error[k];
}

}  // namespace

std::vector<std::uint8_t> diffused(const Planes& image, std::span<const std::uint8_t> flat,
                                   KnownEntries& entries) {
  const auto width = static_cast<std::size_t>(image.size.width);
  std::vector<std::uint8_t> indices(image.size.pixels());
  // The errors that came to the pixels of this row and the next; one more pixel at each end
  // catches what leaves the image.
  std::vector<Light> here(width + 2), below(width + 2);
  bool leftwards = false;
  for (std::size_t row = 0; row < indices.size(); row += width, leftwards = !leftwards) {
    for (std::size_t step = 0; step < width; ++step) {
      const std::size_t column = leftwards ? width - 1 - step : step;
      const Rgb8 own = image.at(row + column);
      std::uint8_t& index = indices[row + column];
      if (flat[row + column]) {
        index = entries.nearest(own);
        continue;
      }
      const std::size_t at = column + 1;  // of the errors
      const auto [taken, error] = entries.take(entries.aim(own), here[at]);
      index = taken;
      const std::size_t ahead = leftwards ? at - 1 : at + 1, behind = leftwards ? at + 1 : at - 1;
      add(here[ahead], error, 7.0 / 16);
      add(below[behind], error, 3.0 / 16);
      add(below[at], error, 5.0 / 16);
      add(below[ahead], error, 1.0 / 16);
    }
    here.swap(below);
    std::fill(below.begin(), below.end(), Light{});
  }
  return indices;
}

}  // namespace sir::quant
