#include "eltek/dac.h"

#include <array>
#include <cstddef>

namespace sir::eltek {
namespace {

constexpr std::array<std::uint8_t, 64> kLevels = [] {
  std::array<std::uint8_t, 64> levels{};
  for (std::size_t code = 0; code < levels.size(); ++code)
    levels[code] = quant::seen_byte(static_cast<int>(code));
  return levels;
}();

}  // namespace

std::uint8_t dac_level(std::uint8_t code) { return kLevels[code & 63u]; }

Rgb8 dac_colour(const quant::DacCode& codes) {
  return {dac_level(codes[0]), dac_level(codes[1]), dac_level(codes[2])};
}

}  // namespace sir::eltek
