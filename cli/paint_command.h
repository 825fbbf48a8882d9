// `sir paint`: picked colours shown as others, to bring out areas of interest
// (thesis 3.4.3).
#pragma once

#include <filesystem>
#include <vector>

#include "cli/session.h"
#include "quant/paint.h"
#include "tracer/planes.h"

namespace sir::cli {

struct PaintOptions {
  std::filesystem::path input;          ///< a base name or a PNG file
  std::filesystem::path output;         ///< a PNG file
  std::vector<quant::PaintRule> rules;  ///< the first that picks a pixel paints it
  quant::PaintRule own;                 ///< where the command line gathers a rule's parts
  quant::Rest rest = quant::Rest::keep;
  ImageSize size;  ///< of planes
  bool json = false;
};

/// Writes the painted image and prints how many pixels were painted, for each
/// rule where there are several. None is no error. Throws FileError.
int run_paint(const PaintOptions& options, const Session& session);

}  // namespace sir::cli
