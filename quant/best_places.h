// Which index of the LUT each entry of the method `best` takes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quant/best.h"

namespace sir::quant {

/// Places of the pins, in their order, and those that are free for chosen entries, ascending.
struct Places {
  std::vector<std::size_t> pinned, free;
};

/// Throws std::invalid_argument for what choose_best refuses about entries, pins, reserved indices.
Places places_of(const BestOptions& options);

/// Entries in their places: `codes` are those of the pins and then the chosen ones, which take the
/// free places in their order. See choose_best for the indices that are left.
Lut placed(std::span<const DacCode> codes, const Places& places, const BestOptions& options);

}  // namespace sir::quant
