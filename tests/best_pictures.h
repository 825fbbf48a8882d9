// Pictures for the tests of the method `best`, and what a choice is worth on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quant/best.h"
#include "quant/choose.h"
#include "quant/image_pair.h"
#include "quant/nearest.h"
#include "quant/perceptual_search.h"
#include "tests/random_planes.h"
#include "tracer/planes.h"

namespace sir::test {

inline Planes filled(ImageSize size, Rgb8 colour) {
  Planes image(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) image.set(i, colour);
  return image;
}

/// A pixel for each colour, side by side.
inline Planes row_of(std::span<const Rgb8> colours) {
  Planes image(ImageSize{static_cast<int>(colours.size()), 1});
  for (std::size_t i = 0; i < colours.size(); ++i) image.set(i, colours[i]);
  return image;
}

/// Slopes of all three primaries.
inline Planes slopes(ImageSize size) {
  Planes image(size);
  const auto byte = [](int at, int of) { return static_cast<std::uint8_t>(at * 255 / of); };
  for (int j = 0; j < size.height; ++j)
    for (int i = 0; i < size.width; ++i)
      image.set(static_cast<std::size_t>(j * size.width + i),
                {byte(i, size.width), byte(j, size.height), byte(i + j, size.width + size.height)});
  return image;
}

/// Every `step`th column and row.
inline Planes thinned(const Planes& image, int step) {
  Planes small(ImageSize{image.size.width / step, image.size.height / step});
  for (int j = 0; j < small.size.height; ++j)
    for (int i = 0; i < small.size.width; ++i)
      small.set(static_cast<std::size_t>(j * small.size.width + i),
                image.at(static_cast<std::size_t>(j * step * image.size.width + i * step)));
  return small;
}

/// Noise about a few colours: pictures with narrow and with wide clusters of colours.
inline Planes clusters(ImageSize size, unsigned seed, int count, int width) {
  std::mt19937 random(seed);
  std::vector<Rgb8> centres;
  const auto any = [&] { return static_cast<std::uint8_t>(random()); };
  for (int i = 0; i < count; ++i) centres.push_back({any(), any(), any()});
  Planes image(size);
  const auto about = [&](int byte) {
    const int moved = byte + static_cast<int>(random() % static_cast<unsigned>(width)) - width / 2;
    return static_cast<std::uint8_t>(std::min(std::max(moved, 0), 255));
  };
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const Rgb8 c = centres[random() % centres.size()];
    image.set(i, {about(c.r), about(c.g), about(c.b)});
  }
  return image;
}

inline quant::WeightedColours colours_of(const Planes& image) {
  quant::WeightedColours colours;
  colours.add(image);
  return colours;
}

inline quant::BestChoice best_for(const Planes& image, const quant::BestOptions& options = {}) {
  return quant::choose_best(colours_of(image), options);
}

/// As the goal's own mapping maps.
inline std::vector<std::uint8_t> mapped_for(quant::Goal goal, const Planes& image,
                                            const quant::Lut& lut,
                                            const quant::IndexSet& reserved = {}) {
  return goal == quant::Goal::perceptual
             ? quant::map_perceptually(image, lut, reserved)
             : quant::map_to_lut(image, lut, quant::Mapping::exact, reserved);
}

/// Root of the mean squared difference of pixels and their entries, each pixel taking the one of
/// least difference by the goal's measure. (Mapping by the eye does so near the entries.)
inline double error_of(quant::Goal goal, const Planes& image, const quant::Lut& lut,
                       const quant::IndexSet& reserved = {}) {
  std::set<quant::DacCode> codes;
  for (std::size_t i = 0; i < quant::kLutEntries; ++i)
    if (!reserved[i]) codes.insert(lut.entry[i]);
  quant::ColourMeasure measure(goal);
  double sum = 0, weight = 0;
  const quant::WeightedColours colours = colours_of(image);
  for (const quant::WeightedColour& one : colours.all()) {
    float least = std::numeric_limits<float>::infinity();
    for (const quant::DacCode& code : codes)
      least = std::min(least, measure.difference(one.colour, quant::seen(code, lut.dac)));
    sum += one.weight * double{least};
    weight += one.weight;
  }
  return std::sqrt(sum / weight);
}

inline const char* name_of(quant::Goal goal) {
  return goal == quant::Goal::psnr ? "psnr" : "perceptual";
}

inline constexpr quant::Goal kGoals[] = {quant::Goal::perceptual, quant::Goal::psnr};

}  // namespace sir::test
