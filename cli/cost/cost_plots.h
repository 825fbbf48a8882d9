// The plots of the price list, as scripts for gnuplot.
#pragma once

#include <string>
#include <vector>

#include "cli/cost/cost_data.h"

namespace sir::cli {

struct CostPlot {
  std::string title;    ///< what it shows, in words
  std::string caption;  ///< how it is to be read
  std::string script;   ///< writes an SVG to standard output
};

/// Time against PSNR with the front, the depth's curve, the antialiasing's; each
/// where there are rows for it.
std::vector<CostPlot> tracer_plots(const CostPart& part);

/// Time against PSNR with the front, the efforts of the method best; each where there are rows for
/// it.
std::vector<CostPlot> lut_plots(const CostPart& part);

}  // namespace sir::cli
