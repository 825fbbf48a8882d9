#include "quant/dac_parse.h"

#include <charconv>

namespace sir::quant {

bool parse_bits(std::string_view text, DacBits& dac) {
  DacBits read;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int& bits : read.bits) {
    const bool first = &bits == read.bits.data();
    if (!first && (at == end || *at++ != ',')) return false;
    const auto [stop, failure] = std::from_chars(at, end, bits);
    if (failure != std::errc{}) return false;
    at = stop;
    if (first && at == end) {
      read.bits.fill(bits);
      break;
    }
  }
  if (at != end || !read.valid()) return false;
  dac = read;
  return true;
}

std::string bits_text(const DacBits& dac) {
  return std::to_string(dac.bits[0]) + "," + std::to_string(dac.bits[1]) + "," +
         std::to_string(dac.bits[2]);
}

}  // namespace sir::quant
