// Banding: false contours where the image was smooth.
#pragma once

#include "tracer/planes.h"

namespace sir::quant {

/// How much false contours are seen: the root of the mean, over all pairs of
/// pixels side by side or one above the other, of the square of what a false
/// contour adds to the pair's CIEDE2000. 0 for an image without such pairs.
///
/// A pair holds a false contour if
/// - the reference is smooth around both: within two rows and columns no pixel
///   differs from a neighbour, and none bends away from the line through two
///   neighbours (x[-1] - 2 x[0] + x[1]), by more than 4 levels in a plane. That
///   is the DAC's own step: a steeper slope has its steps pixel by pixel, a
///   stronger texture hides them;
/// - the shown image steps from one even stretch to another there: each of the two pixels equals
///   the next two away from the pair;
/// - the step goes on: in the lines before and after, the same two colours meet, at most one pixel
///   further along. A contour is a line. Dither has even stretches too, by chance and by its
///   pattern, but they seldom line up.
/// What it adds is the CIEDE2000 across the pair as shown less that of the
/// reference, where positive. The square makes one step of two just-visible
/// differences count more than two steps of one; otherwise fewer and coarser
/// bands would weigh the same.
///
/// The idea, small steps between flat regions weighted by their contrast, is
/// that of CAMBI (Tandon, Afonso, Sole and Krasula 2021); with the reference at
/// hand smoothness need not be guessed from the shown image, nor at several scales.
/// Throws std::invalid_argument for images of different sizes or without pixels.
double banding(const Planes& reference, const Planes& shown);

}  // namespace sir::quant
