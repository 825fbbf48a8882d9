// What dithering knows of a LUT's entries, and how far it may stray from a colour.
#pragma once

#include <array>
#include <cstdint>

#include "quant/colour_table.h"
#include "quant/dither.h"
#include "quant/linear_light.h"
#include "quant/lut.h"

namespace sir::quant {

/// The share of an error that others make good. All of it would be right in the mean, but where
/// no mixture of entries reaches a colour the error would grow, and break out far from where it
/// arose; and each further step towards all costs more noise than it gains in the mean.
inline constexpr double kErrorShare = 0.85;

/// How far, in levels of a byte in each primary, the colour that is looked for may be from the
/// pixel's own, whose nearest entry is `off` levels from it in the primary where that is most.
///
/// Without a leash errors add up in corners of the colour space where entries are few, until one
/// of quite another hue is the nearest: single red pixels in brown hair. Where an entry is near,
/// two steps of the DAC are enough to reach its neighbours. Far from all entries the leash must
/// reach past the middle between two that are 2 off apart and more; the square lets go of
/// it soon, so that two entries are enough to mix all but the ends of the greys between.
constexpr int leash(int off) {
  const int far = off * off / 4;
  return far < 8 ? 8 : far < 255 ? far : 255;
}

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

  /// A pixel's colour, and what may be looked for in its place: primaries from `least` to `most`,
  /// within the leash() of its own colour.
  struct Aim {
    Light light, least, most;
    std::uint8_t closest;  ///< the entry nearest to the colour
    bool met;              ///< that entry is seen as exactly this colour
  };
  Aim aim(Rgb8 own);

  /// What a pixel takes that is to make good an error as well, and the error that is left then.
  /// The light looked for is the sum of its own and the error, held within the aim's bounds. What
  /// the entry lacks of the sum itself is left, times kErrorShare: cutting errors at the bounds,
  /// too, would make mixtures of few entries too bright. A colour that an entry is seen as
  /// takes this entry whatever the error.
  struct Taken {
    std::uint8_t index;
    Light error;
  };
  Taken take(const Aim& aim, const Light& error);

  /// The entries by their luminance (of sRGB's primaries), the lower index first among equals:
  /// where this one stands, 0 to 255.
  std::uint8_t place(std::uint8_t index) const { return place_[index]; }

 private:
  const NearestEntry& ask_;
  const LinearLight& curve_;
  ColourTable<std::int16_t> nearest_{-1};
  std::array<Rgb8, kLutEntries> seen_;
  std::array<Light, kLutEntries> light_;
  std::array<std::uint8_t, kLutEntries> place_;
};

}  // namespace sir::quant
