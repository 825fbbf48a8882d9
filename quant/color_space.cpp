#include "quant/color_space.h"

#include <algorithm>
#include <cmath>

namespace sir::quant {

Hsv rgb_to_hsv(Rgb colour) {
  const auto [r, g, b] = colour;
  const double max = std::max({r, g, b});
  const double chroma = max - std::min({r, g, b});
  if (chroma == 0) return {0, 0, max};
  const double rc = (max - r) / chroma;
  const double gc = (max - g) / chroma;
  const double bc = (max - b) / chroma;
  double h = r == max ? bc - gc : g == max ? 2 + rc - bc : 4 + gc - rc;
  h *= 60;
  if (h < 0) h += 360;
  if (h >= 360) h = 0;  // a hue of -1e-20 rounds to 360, which is 0
  return {h, chroma / max, max};
}

Rgb hsv_to_rgb(Hsv colour) {
  const auto [h, s, v] = colour;
  if (s == 0) return {v, v, v};
  const double sixth = h == 360 ? 0 : h / 60;
  const double i = std::floor(sixth);
  const double f = sixth - i;
  const double p = v * (1 - s);
  const double q = v * (1 - s * f);
  const double t = v * (1 - s * (1 - f));
  switch (static_cast<int>(i)) {
    case 0: return {v, t, p};
    case 1: return {q, v, p};
    case 2: return {p, v, t};
    case 3: return {p, q, v};
    case 4: return {t, p, v};
    default: return {v, p, q};
  }
}

Hsv hsv_of(Rgb8 colour) {
  const auto [max, chroma, sixth] = hexagon_of(colour);
  const double v = max / 255.0;
  if (chroma == 0) return {0, 0, v};
  // One division of integers each, so that nothing is rounded twice.
  return {static_cast<double>(60 * sixth) / chroma, static_cast<double>(chroma) / max, v};
}

}  // namespace sir::quant
