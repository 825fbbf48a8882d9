// The lattice point of a DAC that serves a group of colours best.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "quant/colour_measure.h"
#include "quant/dac_code.h"
#include "quant/form_sum.h"

namespace sir::quant {

/// Calls visit(code) for the DAC's codes that differ from `centre` by at most `reach` in every
/// primary, but not for `centre` itself.
template <typename Visit>
void for_each_around(const DacCode& centre, const DacBits& dac, int reach, Visit visit) {
  const auto low = [&](std::size_t c) { return std::max(centre[c] - reach, 0); };
  const auto high = [&](std::size_t c) { return std::min(centre[c] + reach, dac.max_code(c)); };
  for (int r = low(0); r <= high(0); ++r)
    for (int g = low(1); g <= high(1); ++g)
      for (int b = low(2); b <= high(2); ++b) {
        const DacCode code{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                           static_cast<std::uint8_t>(b)};
        if (code != centre) visit(code);
      }
}

/// Looks for the code of least cost, the cost being sum.cost() at the colour as which the DAC
/// shows it. From the code nearest to the colours' mean it steps to the best of its 26 neighbours
/// until none is better, then likewise among the 124 around: colours that look alike do not lie
/// along the DAC's axes. With `from`, it starts there, and ends nowhere worse. With `allowed`,
/// codes for which it is false are no answer; `from` must be given then, and be allowed.
DacCode best_code(const FormSum& sum, const DacBits& dac, ColourMeasure& measure,
                  const DacCode* from = nullptr,
                  const std::function<bool(const DacCode&)>& allowed = {});

}  // namespace sir::quant
