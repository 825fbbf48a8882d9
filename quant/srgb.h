// The primaries of sRGB (IEC 61966-2-1); its curve is in quant/linear_light.h.
#pragma once

namespace sir::quant {

/// XYZ of the three primaries in its columns, white having Y = 1.
inline constexpr double kLinearToXyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                              {0.2126729, 0.7151522, 0.0721750},
                                              {0.0193339, 0.1191920, 0.9503041}};

}  // namespace sir::quant
