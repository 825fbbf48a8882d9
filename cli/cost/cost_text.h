// The price list as text.
#pragma once

#include <string>

#include "cli/cost/cost_data.h"

namespace sir::cli {

/// Tables, sentences and answers of each image, then the legend.
std::string cost_text(const CostReport& report);

}  // namespace sir::cli
