// The columns of the price list as a person reads them, and what they mean.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/cost/cost_data.h"

namespace sir::cli {

struct CostColumn {
  std::string group;  ///< columns of one group stand together
  std::string title;
  std::string (*cell)(const CostRow& row);
};

const std::vector<CostColumn>& tracer_columns();
const std::vector<CostColumn>& lut_columns();

/// Terms and their meaning, of the parts that the report has.
std::vector<std::pair<std::string, std::string>> cost_legend(const CostReport& report);

/// "whitted, 640x480"
std::string title_of(const CostImage& image);

}  // namespace sir::cli
