// The codes that a monitor's LUT holds: six bits per primary on the MA120 (thesis 3.4),
// other numbers of bits on other hardware.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tracer/planes.h"

namespace sir::quant {

/// The largest intensity of a primary in the MA120's LUT.
inline constexpr int kMaxCode = 63;

/// One LUT entry: the intensities of r, g and b, each from 0 to the DAC's largest code.
using DacCode = std::array<std::uint8_t, 3>;

/// The bits per primary of a DAC, r, g, b: 1 to 8 each. The MA120 and the VGA have 6,6,6, the
/// Amiga 4,4,4, "high colour" 5,6,5, today's displays 8,8,8.
struct DacBits {
  std::array<int, 3> bits{6, 6, 6};

  constexpr int max_code(std::size_t channel) const { return (1 << bits[channel]) - 1; }
  constexpr bool valid() const {
    for (const int one : bits)
      if (one < 1 || one > 8) return false;
    return true;
  }
  friend bool operator==(const DacBits&, const DacBits&) = default;
};

/// The byte as which a DAC of so many bits shows a code: 255 e / (2^bits - 1), rounded.
constexpr std::uint8_t seen_byte(int code, int bits = 6) {
  const int most = (1 << bits) - 1;
  return static_cast<std::uint8_t>((2 * 255 * code + most) / (2 * most));
}

/// The colour as which an entry is seen.
constexpr Rgb8 seen(const DacCode& code, const DacBits& dac = {}) {
  return {seen_byte(code[0], dac.bits[0]), seen_byte(code[1], dac.bits[1]),
          seen_byte(code[2], dac.bits[2])};
}

}  // namespace sir::quant
