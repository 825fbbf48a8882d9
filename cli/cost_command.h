// `sir cost`: what the choices of a LUT cost in time and give in quality
// (thesis 3.4, 4.4).
#pragma once

#include <filesystem>
#include <vector>

#include "cli/session.h"
#include "quant/choose.h"
#include "tracer/planes.h"

namespace sir::cli {

struct CostOptions {
  std::vector<std::filesystem::path> inputs;  ///< base names or PNG files
  ImageSize size;                             ///< of planes
  quant::ChooseOptions own;                   ///< a row of the person's own
  bool has_own = false;
  int repeats = 5;
  bool json = false;
};

/// Prints, for each image, a row for each choice: occupied cells, entries,
/// milliseconds for counting and choosing (median of `repeats` runs, the
/// choices in turn, so that a slow spell of the machine hits all of them), and
/// how far the image as seen is from the true one. Throws FileError; returns
/// kInterrupted where it was stopped, having printed nothing.
int run_cost(const CostOptions& options, const Session& session);

}  // namespace sir::cli
