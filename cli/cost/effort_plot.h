// The plot of the method best: what its efforts cost and give, for both of its goals.
#pragma once

#include "cli/cost/cost_plots.h"

namespace sir::cli {

/// Empty where there are no rows for it.
CostPlot effort_plot(const CostPart& part);

}  // namespace sir::cli
