// Blue noise: thresholds without clumps, for dithering by position.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sir::quant {

/// A square of thresholds that tiles the plane, made by void and cluster (Ulichney 1993):
/// however many ranks from the lowest are switched on, the pixels lie evenly, at no regular
/// distance. So a dither by it has next to no energy at low frequencies, where the eye is
/// sharpest, and no pattern.
class BlueNoise {
 public:
  static constexpr std::size_t kSide = 64;
  static constexpr std::size_t kRanks = kSide * kSide;

  /// The one mask, made when it is first asked for; the same on every machine.
  static const BlueNoise& mask();

  /// 0 to kRanks - 1, each once in the square; of any column and row.
  std::uint16_t rank(std::size_t column, std::size_t row) const {
    return ranks_[row % kSide * kSide + column % kSide];
  }

 private:
  BlueNoise();

  std::array<std::uint16_t, kRanks> ranks_;
};

}  // namespace sir::quant
