#include "quant/srgb.h"

#include <cmath>
#include <cstddef>

namespace sir::quant {

double linear_light(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

const std::array<double, 256>& linear_bytes() {
  static const auto table = [] {
    std::array<double, 256> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = linear_light(static_cast<double>(i) / 255);
    return bytes;
  }();
  return table;
}

}  // namespace sir::quant
