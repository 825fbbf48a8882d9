// `sir lut`: chooses the LUT of an image and writes it (thesis 3.4, and the method `best`).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/session.h"
#include "quant/best.h"
#include "quant/choose.h"
#include "tracer/planes.h"

namespace sir::cli {

/// What the method `best` takes besides the image.
struct BestCommand {
  quant::BestOptions options;
  std::optional<std::filesystem::path> from;  ///< a LUT to start from
  std::vector<std::filesystem::path> masks;   ///< none, or one for each image: its importance
  std::optional<quant::DacBits> dac;          ///< as given; else that of `from`, else 6,6,6
};

struct LutOptions {
  std::vector<std::filesystem::path> inputs;    ///< base names or PNG files; one, but for `best`
  std::optional<std::filesystem::path> output;  ///< else BASE.LUT, or FILE.LUT; needed for several
  ImageSize size;                               ///< of planes
  quant::ChooseOptions choice;      ///< method, space, split, grid and its limits, sample
  std::optional<BestCommand> best;  ///< in place of `choice`'s method
  bool json = false;
};

/// Chooses and writes the LUT; prints the number of colours of the image in
/// both grids (as sampled; of several images, in all of them), the number of entries chosen, and
/// the times in milliseconds. The times are those of the method that was asked for:
/// counting in a grid for display only is left out.
/// Throws FileError for what cannot be read or written, std::invalid_argument
/// for a grid or a sample that cannot be (see quant::HsvGridShape::valid).
int run_lut(const LutOptions& options, const Session& session);

}  // namespace sir::cli
