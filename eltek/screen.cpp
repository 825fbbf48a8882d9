#include "eltek/screen.h"

#include <stdexcept>

namespace sir::eltek {
namespace {

template <class Pixel>
std::vector<Pixel> cut(const std::vector<Pixel>& pixels, ImageSize size, const Area& area) {
  if (area.column < 0 || area.row < 0 || area.size.width < 0 || area.size.height < 0 ||
      area.size.width > size.width - area.column || area.size.height > size.height - area.row)
    throw std::out_of_range("an area that leaves the screen");
  std::vector<Pixel> part;
  part.reserve(area.size.pixels());
  for (int row = area.row; row < area.row + area.size.height; ++row) {
    const auto first = pixels.begin() + std::ptrdiff_t{row} * size.width + area.column;
    part.insert(part.end(), first, first + area.size.width);
  }
  return part;
}

}  // namespace

Screen crop(const Screen& screen, const Area& area) {
  return {area.size, cut(screen.pixels, screen.size, area)};
}

IndexedScreen crop(const IndexedScreen& screen, const Area& area) {
  return {area.size, cut(screen.indices, screen.size, area), screen.palette, screen.dac};
}

Planes to_planes(const Screen& screen) {
  Planes planes(screen.size);
  for (std::size_t i = 0; i < screen.pixels.size(); ++i) planes.set(i, screen.pixels[i]);
  return planes;
}

}  // namespace sir::eltek
