#include "eltek/dac.h"

#include <array>
#include <cstddef>

namespace sir::eltek {
namespace {

constexpr int kMostBits = 8;

// The levels of every code, whatever its bits above the converter's, for 1 bit and more.
constexpr auto kLevels = [] {
  std::array<std::array<std::uint8_t, 256>, kMostBits> all{};
  for (int bits = 1; bits <= kMostBits; ++bits)
    for (int code = 0; code < 256; ++code)
      all[static_cast<std::size_t>(bits - 1)][static_cast<std::size_t>(code)] =
          quant::seen_byte(code & ((1 << bits) - 1), bits);
  return all;
}();

}  // namespace

std::uint8_t dac_level(std::uint8_t code, int bits) {
  return kLevels[static_cast<std::size_t>(bits - 1)][code];
}

Rgb8 dac_colour(const quant::DacCode& codes, const quant::DacBits& dac) {
  return {dac_level(codes[0], dac.bits[0]), dac_level(codes[1], dac.bits[1]),
          dac_level(codes[2], dac.bits[2])};
}

}  // namespace sir::eltek
