// The RGB and HSV colour systems (thesis 3.4.2; Smith 1978, Foley and van Dam).
#pragma once

#include "tracer/planes.h"

namespace sir::quant {

/// A colour by its primaries, 0 to 1 each.
struct Rgb {
  double r = 0, g = 0, b = 0;
};

/// A colour by hue in degrees (0 <= h < 360), saturation and value (0 to 1).
struct Hsv {
  double h = 0, s = 0, v = 0;
};

/// The thesis's rgb_para_hsv, with two repairs. A grey (r = g = b) has
/// h = s = 0 and keeps its value: the printed routine divides by zero there.
/// And the hue of red is turned into degrees like the others, which the
/// printed indentation leaves open.
Hsv rgb_to_hsv(Rgb colour);

/// The thesis's hsv_para_rgb; h = 360 is h = 0 (printed there as "b := 0").
/// Takes 0 <= h <= 360.
Rgb hsv_to_rgb(Hsv colour);

/// A stored colour in HSV; each component is the double nearest to the true value.
Hsv hsv_of(Rgb8 colour);

/// The exact hexagon of a stored colour, in integers. Hue, saturation and
/// value are sixth / chroma * 60 degrees, chroma / max and max / 255.
struct HexagonOfBytes {
  int max;     ///< the largest byte
  int chroma;  ///< the largest byte less the smallest
  int sixth;   ///< hue / 60 degrees * chroma: 0 <= sixth < 6 * chroma; 0 for a grey
};

constexpr HexagonOfBytes hexagon_of(Rgb8 colour) {
  const int r = colour.r, g = colour.g, b = colour.b;
  const int larger = r > g ? r : g, smaller = r < g ? r : g;
  const int max = larger > b ? larger : b;
  const int chroma = max - (smaller < b ? smaller : b);
  int sixth = r == max ? g - b : g == max ? 2 * chroma + b - r : 4 * chroma + r - g;
  if (sixth < 0) sixth += 6 * chroma;
  return {max, chroma, sixth};
}

}  // namespace sir::quant
