// Images with picked colours shown as others (thesis 3.4.3: "all colours of a
// certain saturation can be associated with the colour red").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quant/paint_rule.h"
#include "tracer/planes.h"

namespace sir::quant {

/// What becomes of pixels that no rule picks.
enum class Rest {
  keep,
  grey  ///< their luma floor(0.299 r + 0.587 g + 0.114 b + 1/2) (ITU-R BT.601)
};

struct Painted {
  Planes image;
  std::vector<std::uint64_t> picked;  ///< pixels of each rule
};

/// Shows every pixel as the first rule that picks its colour says. Pixels are
/// judged by the colours of `image`, never by what another rule has painted.
Painted paint(const Planes& image, std::span<const PaintRule> rules, Rest rest = Rest::keep);

/// One colour as the brush shows it. Another hue is the exact hsv_to_rgb of
/// the bytes' saturation and value, rounded to bytes by floor(x + 1/2).
Rgb8 brushed(const Brush& brush, Rgb8 colour);

}  // namespace sir::quant
