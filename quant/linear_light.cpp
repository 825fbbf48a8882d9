#include "quant/linear_light.h"

#include <cmath>
#include <limits>

namespace sir::quant {

namespace {

constexpr double kBend = 0.04045;

}  // namespace

double light_of_coded(double coded) {
  return coded <= kBend ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

// The bend lies where the way there has it, so that a colour comes back as it was.
double coded_of_light(double light) {
  return light <= kBend / 12.92 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
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
