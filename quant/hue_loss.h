// Hues that a LUT loses: what the thesis chooses colours in HSV to avoid (thesis 3.4.3).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/planes.h"

namespace sir::quant {

/// What becomes of an image's hues, by the planes of the thesis's grid: 36 hues
/// of 10 degrees, and grey (HsvGrid as it is by default).
struct HueLoss {
  struct PlaneLoss {
    int plane = 0;             ///< 0 to 35: the hue 10 * plane degrees; 36: grey
    std::uint64_t pixels = 0;  ///< of the reference, at least one
    double lost = 0;           ///< share of them that is shown in another plane
  };
  std::vector<PlaneLoss> planes;  ///< the occupied ones of the reference, in order
  double weighted = 0;            ///< share lost of the pixels of all hue planes; 0 without any
  std::vector<int> alarms;        ///< hue planes that are gone, in order
};

/// What a hue of 0 to 360 degrees is called: the nearest of the colour wheel's twelve names, "red",
/// "orange" and so on; half way, the later one.
const char* hue_name(int degrees);

/// Such a CIEDE2000 is plain to see.
inline constexpr double kPlainToSee = 5;

/// The alarms: the hue of a pixel is gone if it is shown in grey, or in a plane
/// that is neither its own nor a neighbour of it, and by a CIEDE2000 of
/// kPlainToSee or more, since a colour that steps over a border of the grid has
/// lost nothing by that; and if the same holds for a square of 2x2 pixels
/// around it, for scattered pixels are noise and no object. A hue plane raises
/// an alarm if the hue of at least half of its pixels is gone, however few they are.
/// Throws std::invalid_argument for images of different sizes or without pixels.
HueLoss hue_loss(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
