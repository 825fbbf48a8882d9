#include "quant/known_entries.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <numeric>

namespace sir::quant {
namespace {

double luminance(const Light& light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

int off_by(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

KnownEntries::KnownEntries(const Lut& lut, const NearestEntry& nearest)
    : ask_(nearest), curve_(LinearLight::table()) {
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    seen_[i] = lut.seen(i);
    light_[i] = curve_.of(seen_[i]);
  }
  std::array<std::uint8_t, kLutEntries> order;
  std::iota(order.begin(), order.end(), std::uint8_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::uint8_t a, std::uint8_t b) {
    return luminance(light_[a]) < luminance(light_[b]);
  });
  for (std::size_t i = 0; i < kLutEntries; ++i) place_[order[i]] = static_cast<std::uint8_t>(i);
}

KnownEntries::Aim KnownEntries::aim(Rgb8 own) {
  const std::uint8_t closest = nearest(own);
  const int off = off_by(own, seen_[closest]), reach = leash(off);
  const auto moved = [&](int by) {
    const auto byte = [by](int of) {
      return static_cast<std::uint8_t>(std::clamp(of + by, 0, 255));
    };
    return curve_.of(Rgb8{byte(own.r), byte(own.g), byte(own.b)});
  };
  return {curve_.of(own), moved(-reach), moved(reach), closest, off == 0};
}

KnownEntries::Taken KnownEntries::take(const Aim& aim, const Light& error) {
  Light wanted;
  for (std::size_t k = 0; k < 3; ++k)
    wanted[k] = std::clamp(aim.light[k] + error[k], aim.least[k], aim.most[k]);
  Taken taken{aim.met ? aim.closest : nearest(curve_.colour(wanted)), {}};
  const Light& shown = light_[taken.index];
  for (std::size_t k = 0; k < 3; ++k)
    taken.error[k] = kErrorShare * (aim.light[k] + error[k] - shown[k]);
  return taken;
}

}  // namespace sir::quant
