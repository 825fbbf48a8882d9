// The codes that the monitor's LUT holds: six bits per primary (thesis 3.4).
#pragma once

#include <array>
#include <cstdint>

#include "tracer/planes.h"

namespace sir::quant {

/// The largest intensity of a primary in the LUT.
inline constexpr int kMaxCode = 63;

/// One LUT entry: the intensities of r, g and b, 0 to 63 each.
using Code6 = std::array<std::uint8_t, 3>;

/// The byte as which the DAC shows a code: 255 e / 63, rounded.
constexpr std::uint8_t seen_byte(int code) {
  return static_cast<std::uint8_t>((170 * code + 21) / 42);
}

/// The colour as which an entry is seen.
constexpr Rgb8 seen(const Code6& code) {
  return {seen_byte(code[0]), seen_byte(code[1]), seen_byte(code[2])};
}

}  // namespace sir::quant
