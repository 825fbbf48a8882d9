// Small pictures on disk, each with a LUT file, and what the MA120 must show of them.
#pragma once

#include <filesystem>
#include <string>

#include "eltek/dac.h"
#include "quant/lut.h"
#include "quant/nearest.h"
#include "tracer/planes.h"
#include "viewer/png_file.h"

namespace sir::test {

/// A picture with many colours.
inline Planes made_picture(ImageSize size, unsigned seed) {
  Planes planes(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const auto byte = [&](std::size_t factor) {
      return static_cast<std::uint8_t>(i * factor * seed + i / 64 * 5);
    };
    planes.set(i, {byte(3), byte(7), byte(1)});
  }
  return planes;
}

inline quant::Lut made_lut(unsigned seed) {
  quant::Lut lut;
  for (std::size_t i = 0; i < quant::kLutEntries; ++i)
    lut.entry[i] = {static_cast<std::uint8_t>(i * seed % 64), static_cast<std::uint8_t>(i / 4),
                    static_cast<std::uint8_t>((255 - i) % 64)};
  lut.chosen = quant::kLutEntries;
  return lut;
}

/// FOLDER/NAME.png and FOLDER/NAME.LUT.
inline std::filesystem::path write_picture(const std::filesystem::path& folder,
                                           const std::string& name, ImageSize size, unsigned seed) {
  const auto path = folder / (name + ".png");
  viewer::write_rgb_png(path, made_picture(size, seed));
  quant::write_lut(folder / (name + ".LUT"), made_lut(seed));
  return path;
}

/// The colour that a pixel of made_picture(size, seed) is seen as through made_lut(seed).
inline Rgb8 shown_colour(ImageSize size, unsigned seed, int column, int row, int mask = 0xFF) {
  const quant::Lut lut = made_lut(seed);
  const Rgb8 colour =
      made_picture(size, seed).at(static_cast<std::size_t>(row * size.width + column));
  return lut.seen(static_cast<std::size_t>(quant::nearest_entry(colour, lut) & mask));
}

}  // namespace sir::test
