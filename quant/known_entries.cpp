#include "quant/known_entries.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace sir::quant {
namespace {

double luminance(const Light& light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

/// The light that a primary of some byte may want at least and at most.
struct Leash {
  double least, most;
};

const std::array<Leash, 256>& leashes() {
  static const auto made = [] {
    std::array<Leash, 256> all{};
    for (int byte = 0; byte < 256; ++byte)
      all[static_cast<std::size_t>(byte)] = {
          light_of(static_cast<std::uint8_t>(std::max(byte - kLeash, 0))),
          light_of(static_cast<std::uint8_t>(std::min(byte + kLeash, 255)))};
    return all;
  }();
  return made;
}

}  // namespace

KnownEntries::KnownEntries(const Lut& lut, const NearestEntry& nearest) : ask_(nearest) {
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    seen_[i] = lut.seen(i);
    light_[i] = light_of(seen_[i]);
  }
  std::array<std::uint8_t, kLutEntries> order;
  std::iota(order.begin(), order.end(), std::uint8_t{0});
  std::stable_sort(order.begin(), order.end(), [this](std::uint8_t a, std::uint8_t b) {
    return luminance(light_[a]) < luminance(light_[b]);
  });
  for (std::size_t i = 0; i < kLutEntries; ++i) place_[order[i]] = static_cast<std::uint8_t>(i);
}

Light KnownEntries::wanted(Rgb8 colour, const Light& error) {
  const auto held = [](std::uint8_t byte, double by) {
    const Leash& leash = leashes()[byte];
    return std::clamp(light_of(byte) + by, leash.least, leash.most);
  };
  return {held(colour.r, error[0]), held(colour.g, error[1]), held(colour.b, error[2])};
}

}  // namespace sir::quant
