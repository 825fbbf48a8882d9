// `sir lut`: chooses the LUT of an image and writes it (thesis 3.4).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/session.h"
#include "quant/choose.h"
#include "tracer/planes.h"

namespace sir::cli {

struct LutOptions {
  std::filesystem::path input;                  ///< a base name or a PNG file
  std::optional<std::filesystem::path> output;  ///< else BASE.LUT, or FILE.LUT
  ImageSize size;                               ///< of planes
  quant::ChooseOptions choice;  ///< method, space, split, grid and its limits, sample
  bool json = false;
};

/// Chooses and writes the LUT; prints the number of colours of the image in
/// both grids (as sampled), the number of entries chosen, and the times in
/// milliseconds. The times are those of the method that was asked for:
/// counting in the other grid, for display only, is left out.
/// Throws FileError for what cannot be read or written, std::invalid_argument
/// for a grid or a sample that cannot be (see quant::HsvGridShape::valid).
int run_lut(const LutOptions& options, const Session& session);

}  // namespace sir::cli
