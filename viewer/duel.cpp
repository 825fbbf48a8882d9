#include "viewer/duel.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "quant/ciede2000.h"
#include "quant/image_pair.h"

namespace sir::viewer {
namespace {

constexpr std::size_t kBetweenStops = 4096;  // pixels: some milliseconds at worst

/// Luma of the bytes (ITU-R BT.601), as the signal of a black-and-white set.
int luma(Rgb8 c) { return (299 * c.r + 587 * c.g + 114 * c.b + 500) / 1000; }

}  // namespace

Duel duel(const Planes& reference, const Planes& a, const Planes& b, std::stop_token stop) {
  quant::require_pair(reference, a);
  quant::require_pair(reference, b);
  Duel result;
  result.size = reference.size;
  const std::size_t pixels = reference.size.pixels();
  result.winner.resize(pixels);
  quant::ColourDifference difference;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (i % kBetweenStops == 0 && stop.stop_requested()) return {};
    const Rgb8 colour = reference.at(i);
    const double of_a = difference(colour, a.at(i)), of_b = difference(colour, b.at(i));
    result.mean_a += of_a;
    result.mean_b += of_b;
    const bool tie = std::abs(of_a - of_b) < kEqualToTheEye;
    result.winner[i] = tie ? Winner::tie : of_a < of_b ? Winner::a : Winner::b;
    ++(tie ? result.ties : of_a < of_b ? result.won_by_a : result.won_by_b);
  }
  result.mean_a /= static_cast<double>(pixels);
  result.mean_b /= static_cast<double>(pixels);
  return result;
}

Planes duel_map(const Planes& reference, const Duel& duel) {
  if (!(reference.size == duel.size)) throw std::invalid_argument("a duel over another picture");
  Planes map(reference.size);
  for (std::size_t i = 0; i < duel.winner.size(); ++i) {
    // Ties: greys of 0 to 102. A winner's colour from 40 to 100 % of itself, so that the picture
    // shows through and the hue does not depend on it.
    const int grey = luma(reference.at(i));
    const auto shaded = [&](int byte) {
      return static_cast<std::uint8_t>(byte * (170 + grey) / 425);
    };
    const auto dim = static_cast<std::uint8_t>(grey * 2 / 5);
    switch (duel.winner[i]) {
      case Winner::tie: map.set(i, {dim, dim, dim}); break;
      case Winner::a:
        map.set(i, {shaded(kColourOfA.r), shaded(kColourOfA.g), shaded(kColourOfA.b)});
        break;
      case Winner::b:
        map.set(i, {shaded(kColourOfB.r), shaded(kColourOfB.g), shaded(kColourOfB.b)});
        break;
    }
  }
  return map;
}

std::vector<std::string> describe(const Duel& duel, const std::string& a, const std::string& b) {
  const auto share = [&](std::uint64_t count) {
    return 100 * static_cast<double>(count) / static_cast<double>(duel.winner.size());
  };
  return {fmt::format("A: {}", a),
          fmt::format("  wins {} pixels ({:.1f} %), CIEDE2000 {:.3f}", duel.won_by_a,
                      share(duel.won_by_a), duel.mean_a),
          fmt::format("B: {}", b),
          fmt::format("  wins {} pixels ({:.1f} %), CIEDE2000 {:.3f}", duel.won_by_b,
                      share(duel.won_by_b), duel.mean_b),
          fmt::format("equal to the eye (within {:g}): {} ({:.1f} %)", kEqualToTheEye, duel.ties,
                      share(duel.ties))};
}

}  // namespace sir::viewer
