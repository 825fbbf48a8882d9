#include "quant/blurred_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "quant/ciede2000.h"
#include "quant/image_pair.h"
#include "quant/linear_light.h"

namespace sir::quant {
namespace {

using Row = std::vector<double>;

/// The Gaussian at 0, 1, 2 ... pixels; its sum does not matter.
Row gaussian(double sigma) {
  Row weights(static_cast<std::size_t>(std::ceil(4 * sigma)) + 1, 1.0);
  for (std::size_t i = 1; i < weights.size(); ++i) {
    const double x = static_cast<double>(i) / sigma;
    weights[i] = std::exp(-0.5 * x * x);
  }
  return weights;
}

/// Blurs `lines` lines of `length` values `step` apart; lines begin `line_step` apart.
void blur_along(Row& values, std::size_t lines, std::size_t line_step, std::size_t length,
                std::size_t step, const Row& weights) {
  Row line(length);
  const std::size_t reach = weights.size() - 1;
  for (std::size_t n = 0; n < lines; ++n) {
    double* const first = values.data() + n * line_step;
    for (std::size_t i = 0; i < length; ++i) line[i] = first[i * step];
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t end = std::min(length - 1, i + reach);
      double sum = 0, weight = 0;
      for (std::size_t k = i - std::min(i, reach); k <= end; ++k) {
        const double w = weights[k > i ? k - i : i - k];
        sum += w * line[k];
        weight += w;
      }
      first[i * step] = sum / weight;
    }
  }
}

/// A plane in linear light, blurred and coded again.
Row blurred(const std::vector<std::uint8_t>& plane, ImageSize size, const Row& weights) {
  std::array<double, 256> light{};
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = light_of_coded(static_cast<double>(i) / 255);
  Row values(plane.size());
  std::transform(plane.begin(), plane.end(), values.begin(),
                 [&](std::uint8_t byte) { return light[byte]; });
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  blur_along(values, height, width, width, 1, weights);
  blur_along(values, width, 1, height, width, weights);
  std::transform(values.begin(), values.end(), values.begin(), coded_of_light);
  return values;
}

std::array<Row, 3> blurred(const Planes& image, const Row& weights) {
  return {blurred(image.channel[0], image.size, weights),
          blurred(image.channel[1], image.size, weights),
          blurred(image.channel[2], image.size, weights)};
}

}  // namespace

double blurred_difference(const Planes& reference, const Planes& shown, double sigma) {
  require_pair(reference, shown);
  if (!(sigma >= 0) || !std::isfinite(sigma))
    throw std::invalid_argument("the sigma of a blur must be finite and not negative");
  const Row weights = gaussian(sigma);
  const auto a = blurred(reference, weights), b = blurred(shown, weights);
  double sum = 0;
  for (std::size_t i = 0; i < a[0].size(); ++i)
    sum +=
        ciede2000(lab_of(Rgb{a[0][i], a[1][i], a[2][i]}), lab_of(Rgb{b[0][i], b[1][i], b[2][i]}));
  return sum / static_cast<double>(a[0].size());
}

}  // namespace sir::quant
