#include "quant/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace sir::quant {
namespace {

constexpr std::size_t kSide = BlueNoise::kSide, kCells = BlueNoise::kRanks;
constexpr double kSigma = 1.5;  // Ulichney's, in pixels
constexpr int kReach = 9;       // six sigma: the Gaussian is below 2^-25 farther out

/// Dots on a torus, and at each cell how crowded it is: the sum of a Gaussian over all dots.
/// In whole numbers, so that taking a dot away undoes exactly what setting it did.
class Dots {
 public:
  Dots() : set_(kCells), crowd_(kCells) {
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x)
        weights_.push_back(static_cast<std::uint32_t>(
            std::floor(std::ldexp(std::exp(-(x * x + y * y) / (2 * kSigma * kSigma)), 24) + 0.5)));
  }

  bool at(std::size_t cell) const { return set_[cell] != 0; }

  void put(std::size_t cell, bool dot) {
    set_[cell] = dot;
    auto weight = weights_.begin();
    for (std::size_t y = 0; y <= 2 * kReach; ++y) {
      const std::size_t row = (cell / kSide + kSide - kReach + y) % kSide * kSide;
      for (std::size_t x = 0; x <= 2 * kReach; ++x, ++weight) {
        std::uint32_t& crowd = crowd_[row + (cell + kSide - kReach + x) % kSide];
        crowd = dot ? crowd + *weight : crowd - *weight;
      }
    }
  }

  /// The most crowded dot, and the least crowded cell without one; the first among equals.
  std::size_t tightest() const {
    return best([this](std::size_t i) { return set_[i] ? crowd_[i] + 1 : 0; });
  }
  std::size_t emptiest() const {
    return best([this](std::size_t i) { return set_[i] ? 0 : ~crowd_[i]; });
  }

 private:
  template <typename Value>
  static std::size_t best(Value value) {
    std::uint32_t most = value(0);
    for (std::size_t i = 1; i < kCells; ++i) most = std::max(most, value(i));
    std::size_t first = 0;
    while (value(first) != most) ++first;
    return first;
  }

  std::vector<std::uint8_t> set_;
  std::vector<std::uint32_t> crowd_;  // below 2^28: the weights' sum is 2 pi sigma^2 2^24
  std::vector<std::uint32_t> weights_;
};

/// A tenth of the cells at random, moved from the tightest places to the emptiest until the
/// emptiest place is the one just left.
Dots even_start() {
  Dots dots;
  std::mt19937 random(1993);
  for (std::size_t n = 0; n < kCells / 10;) {
    const std::size_t cell = random() % kCells;
    if (dots.at(cell)) continue;
    dots.put(cell, true);
    ++n;
  }
  for (;;) {
    const std::size_t from = dots.tightest();
    dots.put(from, false);
    const std::size_t to = dots.emptiest();
    dots.put(to, true);
    if (to == from) return dots;
  }
}

}  // namespace

const BlueNoise& BlueNoise::mask() {
  static const BlueNoise mask;
  return mask;
}

BlueNoise::BlueNoise() {
  const Dots start = even_start();
  Dots falling = start;
  for (std::size_t rank = kCells / 10; rank-- > 0;) {
    const std::size_t cell = falling.tightest();
    falling.put(cell, false);
    ranks_[cell] = static_cast<std::uint16_t>(rank);
  }
  // Past one half Ulichney looks for the tightest cluster of empty cells. On a torus the Gaussians
  // of dots and of empty cells add up to the same everywhere: that is the emptiest cell still.
  Dots rising = start;
  for (std::size_t rank = kCells / 10; rank < kCells; ++rank) {
    const std::size_t cell = rising.emptiest();
    rising.put(cell, true);
    ranks_[cell] = static_cast<std::uint16_t>(rank);
  }
}

}  // namespace sir::quant
