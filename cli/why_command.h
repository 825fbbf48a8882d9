// `sir why`: all that is known of one pixel, from its ray to its entry's code
// (thesis 2.4, 3.4, 3.5).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/session.h"
#include "quant/map_image.h"
#include "tracer/planes.h"
#include "viewer/method.h"

namespace sir::cli {

struct WhyOptions {
  std::filesystem::path input;  ///< BASE, with its planes, or FILE.png
  int column = 0, row = 0;      ///< of the pixel, from the top left
  /// How the LUT is chosen; none: out of `lut`, else BASE.LUT, else by median in hsv.
  std::optional<viewer::Method> method;
  std::optional<std::filesystem::path> lut;  ///< not with a method
  quant::MapOptions map;
  ImageSize size;  ///< of planes
  bool json = false;
};

/// Prints what is known of the pixel. The ray is told where BASE's scene is there. Throws FileError
/// for what cannot be read and for a pixel beyond the image.
int run_why(const WhyOptions& options, const Session& session);

}  // namespace sir::cli
