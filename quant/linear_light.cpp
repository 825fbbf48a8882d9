#include "quant/linear_light.h"

#include <cmath>
#include <limits>

namespace sir::quant {

double light_of_coded(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

const LinearLight& LinearLight::table() {
  static const LinearLight made;
  return made;
}

LinearLight::LinearLight() {
  for (std::size_t i = 0; i < 256; ++i) {
    light_[i] = light_of_coded(static_cast<double>(i) / 255);
    begin_[i] = light_of_coded((static_cast<double>(i) - 0.5) / 255);
  }
  begin_[256] = std::numeric_limits<double>::infinity();
  std::size_t byte = 0;
  for (std::size_t bin = 0; bin <= kBins; ++bin) {
    while (begin_[byte + 1] <= static_cast<double>(bin) / kBins) ++byte;
    at_left_[bin] = static_cast<std::uint8_t>(byte);
  }
}

}  // namespace sir::quant
