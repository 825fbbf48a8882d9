// The LUT's settings on the price list (thesis 3.4, 3.5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/cost/knob.h"
#include "quant/choose.h"

namespace sir::cli {

/// How the nearest entry of a pixel is found.
enum class Search : std::uint8_t { exact, approximate, exhaustive };

/// A choice of LUT and of mapping, with its words (see CostRow).
struct LutSetting {
  std::optional<Knob> knob;  ///< none: the default, or the person's own
  std::string name, subject, family;
  double at = 0;
  quant::ChooseOptions choice;
  Search search = Search::exact;
};

/// The default (median cut in HSV by pixels, every pixel, exact), then the other
/// positions of each knob wanted, then `own`, if any.
std::vector<LutSetting> lut_settings(const KnobSet& only,
                                     const std::optional<quant::ChooseOptions>& own);

/// LUT indices of the image's pixels, found as `search` says.
std::vector<std::uint8_t> map_by(Search search, const Planes& image, const quant::Lut& lut);

}  // namespace sir::cli
