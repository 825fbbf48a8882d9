// The sRGB colour space (IEC 61966-2-1): stored bytes, linear light, tristimulus values.
#pragma once

#include <array>

namespace sir::quant {

/// XYZ of the three primaries in its columns, white having Y = 1.
inline constexpr double kLinearToXyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                              {0.2126729, 0.7151522, 0.0721750},
                                              {0.0193339, 0.1191920, 0.9503041}};

/// Linear light, 0 to 1, of a coded primary, 0 to 1.
double linear_light(double coded);

/// The same for the 256 bytes, byte / 255 being the coded primary.
const std::array<double, 256>& linear_bytes();

}  // namespace sir::quant
