// Colours as words for windows. The thesis has no windows.
#pragma once

#include <cstdint>

#include "tracer/planes.h"

namespace sir::viewer {

/// 0xAARRGGBB, the layout of SDL_PIXELFORMAT_ARGB8888; an alpha of 255 covers, a lesser one lets
/// the ground shine through.
using Argb = std::uint32_t;

constexpr Argb argb(Rgb8 colour, std::uint8_t alpha = 255) {
  return Argb{alpha} << 24 | Argb{colour.r} << 16 | Argb{colour.g} << 8 | Argb{colour.b};
}

constexpr Rgb8 rgb(Argb word) {
  return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
          static_cast<std::uint8_t>(word)};
}

}  // namespace sir::viewer
