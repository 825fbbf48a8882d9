// Light in proportion to its energy, from stored bytes and back.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tracer/planes.h"

namespace sir::quant {

/// A colour by its primaries in linear light, 0 to 1 each. What the eye mixes at a distance is
/// the mean of these, not of the bytes.
using Light = std::array<double, 3>;

/// The curve of sRGB (IEC 61966-2-1) from a coded primary, 0 to 1, to its light.
double light_of_coded(double coded);

/// And back.
double coded_of_light(double light);

/// The curve for stored bytes, both ways, by tables.
class LinearLight {
 public:
  /// The one table, made when it is first asked for.
  static const LinearLight& table();

  /// light_of_coded(byte / 255).
  double of(std::uint8_t byte) const { return light_[byte]; }
  Light of(Rgb8 colour) const { return {of(colour.r), of(colour.g), of(colour.b)}; }

  /// The way back: the byte whose coded value is nearest, the larger one half-way between two.
  /// That is the largest byte k with light_of_coded((k - 1/2) / 255) <= light, and 0 where there
  /// is none: the curve grows, so each byte has one range of light.
  std::uint8_t byte(double light) const {
    const auto bin = static_cast<std::size_t>(std::clamp(light, 0.0, 1.0) * kBins);
    const std::size_t byte = at_left_[bin];
    return static_cast<std::uint8_t>(byte + (light >= begin_[byte + 1] ? 1 : 0));
  }
  Rgb8 colour(const Light& light) const { return {byte(light[0]), byte(light[1]), byte(light[2])}; }

 private:
  LinearLight();

  /// Bins of equal light. The bytes near black are the closest together, 1 / (255 * 12.92) =
  /// 1 / 3294.6 apart; so no bin holds the beginnings of two bytes.
  static constexpr int kBins = 4096;

  std::array<double, 256> light_;
  std::array<double, 257> begin_;                // of each byte's range; the last never comes
  std::array<std::uint8_t, kBins + 1> at_left_;  // the byte at the left end of a bin
};

}  // namespace sir::quant
