// `sir cost`: the price list of accuracy, in time, of the tracer's settings and
// of the LUT's (thesis 2.4, 3.4, 4.4).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/cost/cost_data.h"
#include "cli/session.h"
#include "tracer/planes.h"

namespace sir::cli {

struct CostOptions {
  std::vector<std::filesystem::path> inputs;  ///< base names or PNG files
  ImageSize size;                             ///< of what is rendered, and of planes
  quant::ChooseOptions own;                   ///< a row of the person's own
  bool has_own = false;
  int repeats = 5;
  int threads = 0;         ///< of the tracer; 0: as many as cores
  int truth_samples = 64;  ///< random rays a pixel of the true picture
  KnobSet only;            ///< empty: all
  CostQuestion question;
  bool json = false;
  std::optional<std::filesystem::path> csv, html;
};

/// Prices the settings of each image: of one with a scene (BASE.CSG) the
/// tracer's and then the LUT's on the rendered picture; of a PNG or of planes
/// without a scene the LUT's alone. Prints tables, sentences and answers, or
/// JSON; writes CSV and a page where asked to. kThreshold where a budget or a
/// target is not met. Throws FileError; returns kInterrupted where it was
/// stopped, having printed and written nothing.
int run_cost(const CostOptions& options, const Session& session);

}  // namespace sir::cli
