// Antialiasing by rays scattered over the pixel (thesis 2.4.5).
#pragma once

#include "tracer/antialias.h"
#include "tracer/sample_points.h"

namespace sir {

/// The place of one of `samples` rays of the pixel in column i and row j of the whole
/// image, within [i, i+1] x [j, j+1]. Correlated multi-jittered (Kensler, Pixar
/// Technical Memo 13-01, 2013, with its permutation): with m = floor(sqrt(samples)) and
/// n = ceil(samples / m) each of n x m equal cells holds one point at most, and so do
/// each of the `samples` rows and each of the n m columns of the pixel. A primary's
/// edge along a row is thus off by less than a sample, whatever the seed. Depends on
/// the arguments alone; the hash is that of splitmix64 (Steele, Lea, Flood 2014).
ScreenPoint scattered_point(std::uint64_t seed, int i, int j, int sample, int samples);

/// Who keeps finished pixels, as which stage, and how what they cost is learnt: the counts of all
/// rays so far.
struct PixelKeeping {
  TileKeeper* keeper = nullptr;
  std::uint32_t stage = 0;
  std::function<RayCounts()> counts;
};

/// The pixels of `region` of an image, as planes of the region's size: each the mean of
/// options.samples samples at scattered_point(). False where the source was stopped. Asks for
/// some 2^16 samples at a time; what `keeping` has of their pixels is not asked for.
bool sample_random(const Region& region, const AntialiasOptions& options,
                   const SampleSource& source, Planes& planes, AntialiasCounts& counts,
                   const PixelKeeping& keeping = {});

}  // namespace sir
