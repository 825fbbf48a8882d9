#include "quant/lattice.h"

#include <stdexcept>

namespace sir::quant {
namespace {

constexpr int kMostBits = 8;

/// The nearest code of every byte. The bytes as seen rise with the code, so that the
/// nearest code never falls from one byte to the next.
constexpr std::array<std::uint8_t, 256> codes_of(int bits) {
  std::array<std::uint8_t, 256> codes{};
  const auto distance = [&](int code, int byte) {
    const int difference = seen_byte(code, bits) - byte;
    return difference < 0 ? -difference : difference;
  };
  int code = 0;
  for (int byte = 0; byte < 256; ++byte) {
    while (code + 1 < 1 << bits && distance(code + 1, byte) < distance(code, byte)) ++code;
    codes[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(code);
  }
  return codes;
}

constexpr auto kCodes = [] {
  std::array<std::array<std::uint8_t, 256>, kMostBits> all{};
  for (int bits = 1; bits <= kMostBits; ++bits)
    all[static_cast<std::size_t>(bits - 1)] = codes_of(bits);
  return all;
}();

}  // namespace

Lattice::Lattice(const DacBits& dac) : dac_(dac), codes_{} {
  if (!dac.valid()) throw std::invalid_argument("a DAC of other than 1 to 8 bits per primary");
  for (std::size_t c = 0; c < 3; ++c)
    codes_[c] = &kCodes[static_cast<std::size_t>(dac.bits[c] - 1)];
}

DacCode nearest_code(Rgb8 colour, const DacBits& dac) { return Lattice(dac).nearest(colour); }

}  // namespace sir::quant
