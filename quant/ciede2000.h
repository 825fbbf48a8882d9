// How different two colours look: CIEDE2000 (CIE 142-2001; Sharma, Wu and Dalal 2005).
#pragma once

#include <cstdint>
#include <vector>

#include "quant/color_space.h"
#include "tracer/planes.h"

namespace sir::quant {

/// CIELAB: lightness 0 to 100; a towards red, b towards yellow.
struct Lab {
  double l = 0, a = 0, b = 0;
};

/// The Lab of a colour taken as sRGB (IEC 61966-2-1): through the exact curve
/// and the matrix of its primaries, relative to its own white, D65. Nothing is
/// adapted to D50 and nothing goes through a profile's tables; white is
/// (100, 0, 0). Primaries from 0 to 1.
Lab lab_of(Rgb colour);
Lab lab_of(Rgb8 colour);

/// CIEDE2000 with all three weights 1, by Little CMS. About 1 is just visible.
double ciede2000(const Lab& a, const Lab& b);

/// CIEDE2000 of stored colours; remembers its last answers, as images repeat
/// their pairs of colours.
class ColourDifference {
 public:
  ColourDifference();
  double operator()(Rgb8 a, Rgb8 b);

 private:
  static constexpr std::uint32_t kNoColour = 0xFFFFFFFF;  // colours have 24 bits, pairs 48
  static constexpr std::uint64_t kNoPair = 0xFFFFFFFFFFFFFFFF;

  struct KnownLab {
    std::uint32_t colour = kNoColour;
    Lab lab;
  };
  struct KnownPair {
    std::uint64_t colours = kNoPair;
    double difference = 0;
  };
  const Lab& lab(Rgb8 colour);

  std::vector<KnownLab> labs_;
  std::vector<KnownPair> pairs_;
};

/// CIEDE2000 between the pixels of two images of one size, rows from the top.
std::vector<double> difference_map(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
