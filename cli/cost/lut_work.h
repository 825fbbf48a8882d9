// The work that a row of the LUT's part is timed at: choosing a LUT, and finding the pixels'
// entries (thesis 3.4, 3.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "quant/best.h"
#include "quant/choose.h"
#include "quant/dither.h"
#include "quant/lut.h"

namespace sir::cli {

/// How the LUT is chosen: by one of the thesis's methods, or by `best`.
using LutChoice = std::variant<quant::ChooseOptions, quant::BestOptions>;

/// How the entry of a pixel is found.
enum class Search : std::uint8_t {
  exact,        ///< the nearest by the bytes
  approximate,  ///< by the bytes, a cell of the lattice as a whole
  exhaustive,   ///< the nearest by the bytes, compared with all entries
  perceptual    ///< the nearest by the eye
};

struct LutMapping {
  Search search = Search::exact;
  quant::Dither dither = quant::Dither::none;  ///< with exact and perceptual only
};

struct ChosenLut {
  quant::Lut lut;
  std::size_t colours = 0;  ///< that it was chosen for: occupied cells; of `best` different colours
  std::size_t entries = 0;  ///< in use
};

/// Counts the image's colours and chooses.
ChosenLut chosen_by(const LutChoice& choice, const Planes& image);

/// LUT indices of the image's pixels.
std::vector<std::uint8_t> mapped_by(const LutMapping& mapping, const Planes& image,
                                    const quant::Lut& lut);

}  // namespace sir::cli
