#include "viewer/half_blocks.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "quant/linear_light.h"

namespace sir::viewer {
namespace {

// The mean of a square, cut off at the screen's edges.
Rgb8 mean(const eltek::Screen& screen, int column, int row, int factor) {
  const auto& table = quant::LinearLight::table();
  const int right = std::min(column + factor, screen.size.width);
  const int below = std::min(row + factor, screen.size.height);
  quant::Light sum{};
  for (int y = row; y < below; ++y)
    for (int x = column; x < right; ++x) {
      const quant::Light light = table.of(screen.pixels[screen.offset(x, y)]);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += light[c];
    }
  const double pixels = (right - column) * (below - row);
  for (double& primary : sum) primary /= pixels;
  return table.colour(sum);
}

std::string select(int ground, Rgb8 colour) {
  return std::to_string(ground) + ";2;" + std::to_string(colour.r) + ";" +
         std::to_string(colour.g) + ";" + std::to_string(colour.b);
}

constexpr int kForeground = 38, kBackground = 48;
constexpr const char* kUpperHalf = "\u2580";
constexpr const char* kReset = "\x1b[0m";

}  // namespace

int half_block_factor(int width, int columns) { return (width + columns - 1) / columns; }

std::string half_blocks(const eltek::Screen& screen, int columns) {
  if (screen.size.width < 1 || screen.size.height < 1 || columns < 1)
    throw std::invalid_argument("half blocks without pixels or columns");
  const int factor = half_block_factor(screen.size.width, columns);
  std::string text;
  for (int row = 0; row < screen.size.height; row += 2 * factor) {
    std::optional<Rgb8> upper, lower;  // as they are set
    for (int column = 0; column < screen.size.width; column += factor) {
      std::string change;
      const auto set = [&](int ground, std::optional<Rgb8>& now, int from_row) {
        if (from_row >= screen.size.height) return;
        const Rgb8 colour = mean(screen, column, from_row, factor);
        if (now == colour) return;
        change.append(change.empty() ? "" : ";").append(select(ground, colour));
        now = colour;
      };
      set(kForeground, upper, row);
      set(kBackground, lower, row + factor);
      if (!change.empty()) text.append("\x1b[").append(change).append("m");
      text += kUpperHalf;
    }
    text.append(kReset).append("\n");
  }
  return text;
}

}  // namespace sir::viewer
