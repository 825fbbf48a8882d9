// How the light of a row of pixels falls on a row of finer, wider or blurred ones. Not in the
// thesis; part of the model of eltek/crt.h.
#pragma once

#include <vector>

namespace sir::eltek {

/// The light of one output pixel: the mean of the source pixels first, first + 1, ... with these
/// weights, which are 0 or more and sum to 1.
struct LightShares {
  int first = 0;
  std::vector<double> weight;
};

/// One for each of `shown` output pixels that cover a row of `pixels` source pixels from end to
/// end. A source pixel is a constant stretch of length 1; a Gaussian spot of standard deviation
/// `spot` >= 0, in source pixels, blurs them; an output pixel takes the mean over its own stretch
/// of pixels / shown. All of this in closed form: without a spot a weight is the part of the output
/// pixel that the source pixel covers. Beyond its ends the row goes on with its last pixels.
/// Throws std::invalid_argument for rows without pixels and for a negative spot.
std::vector<LightShares> light_shares(int pixels, int shown, double spot);

}  // namespace sir::eltek
