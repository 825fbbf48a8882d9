// sir show: images on the MA120's screen (thesis 3.5).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/session.h"
#include "cli/terminal_output.h"
#include "eltek/crt.h"
#include "quant/map_image.h"
#include "tracer/planes.h"

namespace sir::cli {

struct ShowOptions {
  std::vector<std::filesystem::path> inputs;  ///< base names or PNG files; at least one
  std::optional<std::filesystem::path> lut;   ///< for all inputs
  std::optional<std::filesystem::path> png;   ///< write this file, open no window; one input
  ImageSize size;                             ///< of planes
  /// Write the register trace of the session: without a window of showing the images, else of all
  /// that the window's left side does, when it closes.
  std::optional<std::filesystem::path> trace;
  /// > 0: print what each image puts on a bus of so many bytes a second, and how long that takes.
  double bus_rate = 0;
  bool crop = false;                     ///< the image's area alone
  std::optional<eltek::CrtOptions> crt;  ///< the monitor's tube; none: the ideal monitor
  std::optional<TerminalForm> terminal;  ///< on standard output, no window
  quant::MapOptions map;                 ///< how pixels become LUT indices
};

/// Shows the images in a window, or on standard output one below the other, or writes the screen
/// with the one image as an indexed PNG, as an RGB PNG where the monitor is a tube; the tube's
/// numbers are then told in a note. Writes the trace where one is asked for. Without `lut` an image
/// takes BASE.LUT where that exists, else one is chosen by median in hsv and a note says so. Where
/// a LUT is for another DAC than the MA120's, that DAC is fitted and a note says so. Returns an
/// exit code; throws FileError.
int run_show(const ShowOptions& options, const Session& session);

}  // namespace sir::cli
