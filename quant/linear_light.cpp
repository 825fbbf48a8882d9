#include "quant/linear_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sir::quant {
namespace {

/// Bins of equal light. The bytes near black are the closest together, 1 / (255 * 12.92) =
/// 1 / 3294.6 apart; so no bin holds the beginnings of two bytes.
constexpr int kBins = 4096;

struct Tables {
  std::array<double, 256> light;
  std::array<double, 257> begin;                // of each byte's range of light
  std::array<std::uint8_t, kBins + 1> at_left;  // the byte at the left end of a bin

  Tables() {
    for (std::size_t i = 0; i < 256; ++i) {
      light[i] = light_of_coded(static_cast<double>(i) / 255);
      begin[i] = light_of_coded((static_cast<double>(i) - 0.5) / 255);
    }
    begin[256] = std::numeric_limits<double>::infinity();
    std::size_t byte = 0;
    for (std::size_t bin = 0; bin <= kBins; ++bin) {
      while (begin[byte + 1] <= static_cast<double>(bin) / kBins) ++byte;
      at_left[bin] = static_cast<std::uint8_t>(byte);
    }
  }
};

const Tables& tables() {
  static const Tables made;
  return made;
}

}  // namespace

double light_of_coded(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

double light_of(std::uint8_t byte) { return tables().light[byte]; }

std::uint8_t byte_of_light(double light) {
  const auto bin = static_cast<std::size_t>(std::clamp(light, 0.0, 1.0) * kBins);
  const Tables& made = tables();
  const std::uint8_t byte = made.at_left[bin];
  return static_cast<std::uint8_t>(byte + (light >= made.begin[byte + std::size_t{1}]));
}

}  // namespace sir::quant
