// What a person may choose about antialiasing (thesis 2.4.5): more than one ray a
// pixel.
//
// A sample is the three bytes that SIR would write for one ray. An antialiased
// pixel is a mean of samples, taken in integers and rounded half up; it is the
// same for any number of threads, and no effect that may be left out (EffectSet)
// can change a byte of it that it does not change of a sample.
#pragma once

#include <cstdint>
#include <vector>

namespace sir {

enum class Antialias : std::uint8_t {
  none,      ///< one ray, through the pixel's centre
  adaptive,  ///< Whitted's subdivision: sample_adaptive.h
  random     ///< rays scattered over the pixel: sample_random.h
};

struct AntialiasOptions {
  static constexpr int kMaxLevels = 6, kMaxSamples = 4096;

  Antialias mode = Antialias::none;
  int threshold = 16;  ///< adaptive: a square is divided where a primary differs by more, 0..255
  int levels = 2;      ///< adaptive: how often a square may be divided, 0..kMaxLevels
  int samples = 16;    ///< random: rays a pixel, 1..kMaxSamples
  std::uint64_t seed = 1;  ///< random: of the pattern

  /// Whether each number is within its range.
  bool valid() const {
    return threshold >= 0 && threshold <= 255 && levels >= 0 && levels <= kMaxLevels &&
           samples >= 1 && samples <= kMaxSamples;
  }
};

/// What antialiasing cost.
struct AntialiasCounts {
  std::uint64_t points = 0;            ///< of the screen that were traced, each once
  std::vector<std::uint64_t> divided;  ///< adaptive: squares divided, by level, pixels first
};

}  // namespace sir
