// The LUT's settings on the price list (thesis 3.4, 3.5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/cost/knob.h"
#include "cli/cost/lut_work.h"

namespace sir::cli {

/// A choice of LUT and of mapping, with its words (see CostRow).
struct LutSetting {
  std::optional<Knob> knob;  ///< none: the default, or the person's own
  std::string name, subject, family;
  double at = 0;
  LutChoice choice;
  LutMapping mapping;
  double weight = 1;  ///< guess of its time, in the default's
};

/// The default (median cut in HSV by pixels, every pixel, exact), then the other
/// positions of each knob wanted, then `own`, if any. Where a knob is wanted without
/// the one that has the row which its rows are to be compared with, it has that row too.
std::vector<LutSetting> lut_settings(const KnobSet& only,
                                     const std::optional<quant::ChooseOptions>& own);

}  // namespace sir::cli
