#include "quant/flat_areas.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace sir::quant {
namespace {

constexpr int kStep = 4;                // levels of a byte from a code of the DAC to the next
constexpr int kReach = 4;               // steps that are looked ahead from the border
constexpr std::size_t kSlopeShare = 3;  // one pair out of so many makes a slope

using Label = std::uint32_t;

/// The area of each pixel, as numbers from 0 in the order of their first pixels.
struct Areas {
  std::vector<Label> of;
  std::size_t count = 0;
};

/// The first pixel of a tree; shortens the way for the next one who asks.
Label root_of(std::vector<Label>& parent, Label pixel) {
  while (parent[pixel] != pixel) pixel = parent[pixel] = parent[parent[pixel]];
  return pixel;
}

void join(std::vector<Label>& parent, Label a, Label b) {
  a = root_of(parent, a);
  b = root_of(parent, b);
  if (a < b) parent[b] = a;
  else parent[a] = b;
}

Areas areas_of(const Planes& image) {
  Areas areas{std::vector<Label>(image.size.pixels()), 0};
  std::vector<Label>& parent = areas.of;
  std::iota(parent.begin(), parent.end(), Label{0});
  const auto width = static_cast<std::size_t>(image.size.width);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const Rgb8 colour = image.at(i);
    if (i % width > 0 && image.at(i - 1) == colour)
      join(parent, static_cast<Label>(i - 1), static_cast<Label>(i));
    if (i >= width && image.at(i - width) == colour)
      join(parent, static_cast<Label>(i - width), static_cast<Label>(i));
  }
  // A parent stands before its children, so that it has its number by now.
  for (std::size_t pixel = 0; pixel < parent.size(); ++pixel)
    parent[pixel] =
        parent[pixel] == pixel ? static_cast<Label>(areas.count++) : parent[parent[pixel]];
  return areas;
}

/// Whether no two neighbours of five pixels in a row are more than a step apart: from `pixel` on,
/// in steps of `stride` in memory, of which `left` lead to pixels of the image.
bool slopes(const Planes& image, std::size_t pixel, std::ptrdiff_t stride, int left) {
  Rgb8 before = image.at(pixel);
  for (int i = std::min(left, kReach); i > 0; --i) {
    pixel += static_cast<std::size_t>(stride);
    const Rgb8 after = image.at(pixel);
    if (std::abs(after.r - before.r) > kStep || std::abs(after.g - before.g) > kStep ||
        std::abs(after.b - before.b) > kStep)
      return false;
    before = after;
  }
  return true;
}

/// The pixels of an area, the pairs of its border, and those that lead along a slope.
struct Counts {
  std::size_t pixels = 0, border = 0, slope = 0;

  bool flat() const {
    return pixels >= kFlatPixels && (border == 0 || slope * kSlopeShare < border);
  }
};

}  // namespace

std::vector<std::uint8_t> flat_areas(const Planes& image) {
  const Areas areas = areas_of(image);
  std::vector<Counts> counts(areas.count);
  for (const Label area : areas.of) ++counts[area].pixels;
  const int width = image.size.width, height = image.size.height;
  const auto look = [&](std::size_t from, std::size_t to, int left) {
    Counts& of = counts[areas.of[from]];
    if (of.pixels < kFlatPixels || areas.of[from] == areas.of[to]) return;
    ++of.border;
    of.slope += slopes(image, from, static_cast<std::ptrdiff_t>(to - from), left);
  };
  std::size_t pixel = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column, ++pixel) {
      const auto below = static_cast<std::size_t>(width);
      if (column + 1 < width) {
        look(pixel, pixel + 1, width - 1 - column);
        look(pixel + 1, pixel, column + 1);
      }
      if (row + 1 < height) {
        look(pixel, pixel + below, height - 1 - row);
        look(pixel + below, pixel, row + 1);
      }
    }
  std::vector<std::uint8_t> flat(image.size.pixels());
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = counts[areas.of[i]].flat();
  return flat;
}

}  // namespace sir::quant
