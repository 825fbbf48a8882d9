#include "quant/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "quant/ciede2000.h"

namespace sir::quant {
namespace {

// The blue is reddish and dark, or the way from it to the red would first grow darker.
constexpr std::array<Rgb8, 5> kRamp{
    {{0, 0, 0}, {40, 0, 130}, {230, 0, 0}, {255, 220, 0}, {255, 255, 255}}};

std::uint8_t between(int low, int high, double share) {
  return static_cast<std::uint8_t>(std::lround(low + (high - low) * share));
}

}  // namespace

Rgb8 heat_colour(double difference) {
  constexpr std::size_t kSteps = kRamp.size() - 1;
  const double place = std::min(difference / kWhiteHot, 1.0) * static_cast<double>(kSteps);
  const std::size_t step = std::min(static_cast<std::size_t>(place), kSteps - 1);
  const double share = place - static_cast<double>(step);
  const Rgb8 low = kRamp[step], high = kRamp[step + 1];
  return {between(low.r, high.r, share), between(low.g, high.g, share),
          between(low.b, high.b, share)};
}

Planes heat_map(const Planes& reference, const Planes& shown) {
  const auto differences = difference_map(reference, shown);
  Planes map(reference.size);
  for (std::size_t i = 0; i < differences.size(); ++i) map.set(i, heat_colour(differences[i]));
  return map;
}

}  // namespace sir::quant
