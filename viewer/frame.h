// A picture ready for a window. The thesis has no windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tracer/planes.h"

namespace sir::viewer {

/// Columns of a picture, from the first to the one before the end.
struct Columns {
  int first = 0, end = 0;
};

/// Opaque 0xAARRGGBB words (viewer/argb.h), rows from the top.
struct Frame {
  ImageSize size{0, 0};
  std::vector<std::uint32_t> words;

  std::size_t offset(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(column);
  }
  friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace sir::viewer
