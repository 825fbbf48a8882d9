// The price list as a page that needs nothing but itself.
#pragma once

#include <string>

#include "cli/cost/cost_data.h"
#include "cli/cost/gnuplot.h"

namespace sir::cli {

struct CostPage {
  std::string text;
  std::string missing;  ///< why there are no plots, for the person; empty where there are
};

/// No scripts, nothing loaded; light or dark as the reader has it. `draw_by` draws
/// the plots; where it fails the page says so in their place.
CostPage cost_html(const CostReport& report, Drawing (*draw_by)(const std::string&) = draw);

}  // namespace sir::cli
