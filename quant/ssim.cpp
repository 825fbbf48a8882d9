#include "quant/ssim.h"

#include <algorithm>
#include <vector>

#include "quant/image_pair.h"

namespace sir::quant {
namespace {

constexpr int kWindow = 7;
constexpr double kC1 = 0.01 * 255 * 0.01 * 255;
constexpr double kC2 = 0.03 * 255 * 0.03 * 255;

/// Sums over the pixels of a window: whole numbers, so that adding a pixel and
/// taking it away again leaves nothing behind.
struct Sums {
  std::int32_t x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(int a, int b, int sign) {
    x += sign * a;
    y += sign * b;
    xx += sign * a * a;
    yy += sign * b * b;
    xy += sign * a * b;
  }
  void add(const Sums& other, int sign) {
    x += sign * other.x;
    y += sign * other.y;
    xx += sign * other.xx;
    yy += sign * other.yy;
    xy += sign * other.xy;
  }
};

double similarity(const Sums& sums, int pixels) {
  const double n = pixels, to_sample = pixels > 1 ? n / (n - 1) : 0;
  const double x = sums.x / n, y = sums.y / n;
  const double var_x = to_sample * (sums.xx / n - x * x);
  const double var_y = to_sample * (sums.yy / n - y * y);
  const double covariance = to_sample * (sums.xy / n - x * y);
  return (2 * x * y + kC1) * (2 * covariance + kC2) /
         ((x * x + y * y + kC1) * (var_x + var_y + kC2));
}

double mean_similarity(const std::uint8_t* x, const std::uint8_t* y, ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width);
  const int across = std::min(kWindow, size.width), down = std::min(kWindow, size.height);
  std::vector<Sums> columns(width);  // of the last `down` rows
  double sum = 0;
  for (int row = 0; row < size.height; ++row) {
    const auto add_row = [&](int j, int sign) {
      const std::size_t first = static_cast<std::size_t>(j) * width;
      for (std::size_t i = 0; i < width; ++i) columns[i].add(x[first + i], y[first + i], sign);
    };
    add_row(row, 1);
    if (row >= down) add_row(row - down, -1);
    if (row + 1 < down) continue;
    Sums window;
    for (int i = 0; i < size.width; ++i) {
      window.add(columns[static_cast<std::size_t>(i)], 1);
      if (i >= across) window.add(columns[static_cast<std::size_t>(i - across)], -1);
      if (i + 1 >= across) sum += similarity(window, across * down);
    }
  }
  return sum / (static_cast<double>(size.width - across + 1) * (size.height - down + 1));
}

}  // namespace

double ssim(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  double sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel)
    sum += mean_similarity(reference.channel[channel].data(), shown.channel[channel].data(),
                           reference.size);
  return sum / 3;
}

}  // namespace sir::quant
