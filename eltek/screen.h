// Artifact of the MA120: the screen as seen (thesis 3.5).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quant/dac_code.h"
#include "tracer/planes.h"

namespace sir::eltek {

/// A rectangle of pixels; column and row are its upper left corner.
struct Area {
  int column = 0;
  int row = 0;
  ImageSize size{0, 0};
  friend bool operator==(const Area&, const Area&) = default;
};

/// Colours as seen, bytes after the DAC, rows from the top; the pixel in
/// column i and row j is at j * width + i.
struct Screen {
  ImageSize size{0, 0};
  std::vector<Rgb8> pixels;

  Rgb8 at(int column, int row) const { return pixels.at(offset(column, row)); }
  std::size_t offset(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(column);
  }
  friend bool operator==(const Screen&, const Screen&) = default;
};

/// The same screen before the LUT: the index of every pixel as it reaches the
/// table (under the pixel mask), the 256 entries as seen, in LUT order, and the
/// DAC through which they are seen.
struct IndexedScreen {
  ImageSize size{0, 0};
  std::vector<std::uint8_t> indices;
  std::array<Rgb8, 256> palette{};
  quant::DacBits dac{};
  friend bool operator==(const IndexedScreen&, const IndexedScreen&) = default;
};

/// The part of a screen within `area`, which must lie on it, else
/// std::out_of_range.
Screen crop(const Screen& screen, const Area& area);
IndexedScreen crop(const IndexedScreen& screen, const Area& area);

/// The colours split into three planes.
Planes to_planes(const Screen& screen);

}  // namespace sir::eltek
