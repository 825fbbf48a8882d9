// What dithering knows of a LUT's entries, and how far it may stray from a colour.
#pragma once

#include <array>
#include <cstdint>

#include "quant/colour_table.h"
#include "quant/dither.h"
#include "quant/linear_light.h"
#include "quant/lut.h"

namespace sir::quant {

/// The share of an error that is made good by others. All of it would be just in the mean, but
/// where no mixture of entries reaches a colour the error would grow without end, and break out
/// far from where it arose.
inline constexpr double kErrorShare = 0.85;

/// How far the colour that is looked for may be from the pixel's own, in levels of a byte in each
/// primary. Entries are closer together than that where an image has many colours; where
/// they are not, errors add up until an entry of quite another hue is the nearest, and single
/// red pixels stand in brown hair.
inline constexpr int kLeash = 16;

/// The entries of a LUT in linear light, and which is nearest to a colour.
class KnownEntries {
 public:
  KnownEntries(const Lut& lut, const NearestEntry& nearest);

  /// What the caller's measure says, asked once for a colour.
  std::uint8_t nearest(Rgb8 colour) {
    std::int16_t& index = nearest_[colour];
    if (index < 0) index = ask_(colour);
    return static_cast<std::uint8_t>(index);
  }

  /// Whether an entry is seen as exactly this colour: then it is the nearest one.
  bool holds(Rgb8 colour) { return seen_[nearest(colour)] == colour; }

  const Light& light(std::uint8_t index) const { return light_[index]; }

  /// The entries by their luminance (of sRGB's primaries), the lower index first among equals:
  /// where this one stands, 0 to 255.
  std::uint8_t place(std::uint8_t index) const { return place_[index]; }

  /// The light to look for, for a pixel of this colour which is to make good that error: their
  /// sum, held within kLeash.
  static Light wanted(Rgb8 colour, const Light& error);

 private:
  const NearestEntry& ask_;
  ColourTable<std::int16_t> nearest_{-1};
  std::array<Rgb8, kLutEntries> seen_;
  std::array<Light, kLutEntries> light_;
  std::array<std::uint8_t, kLutEntries> place_;
};

}  // namespace sir::quant
