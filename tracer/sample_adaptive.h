// Whitted's antialiasing (1980; thesis 2.4.5): rays through the corners of pixels,
// more where they differ.
#pragma once

#include "tracer/antialias.h"
#include "tracer/sample_points.h"

namespace sir {

/// The pixels of `region` of an image, as planes of the region's size. A pixel is a
/// square with a sample at each corner. Where the samples of a square's corners
/// differ in a primary by more than options.threshold, it is divided into four, at
/// most options.levels times; else it is the mean of its corners. A pixel is the mean
/// of its squares by area.
///
/// Every point of the screen is asked for once at most, those shared by squares and
/// pixels too; a pixel depends on nothing outside it, so that the image of a region
/// is that part of the whole image. Works in rectangles of pixels, so that its memory
/// does not grow with the image (some 2^22 points in the worst case). False where the
/// source was stopped.
bool sample_adaptive(const Region& region, const AntialiasOptions& options,
                     const SampleSource& source, Planes& planes, AntialiasCounts& counts);

}  // namespace sir
