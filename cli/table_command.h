// `sir table`: Table 4.1 of the thesis, ours beside it (thesis 4.4).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/session.h"

namespace sir::cli {

struct TableCommand {
  std::optional<std::filesystem::path> images;  ///< folder of the five scenes
  std::optional<std::filesystem::path> planes;  ///< folder of their planes, already rendered
  int repeats = 5;                              ///< runs of which the median time is told
  bool json = false;
  std::optional<std::filesystem::path> html;  ///< where to write the report
};

/// For each of the five images and each of the two median cuts: the number of
/// colours (occupied cells) and the time of what the thesis timed (reading the
/// planes, counting, choosing, writing the LUT), with the thesis's figures, the
/// quality of the LUT, and the clock of 1989 fitted to the thesis's times; beside
/// them, apart, the method `best` (quant/best.h) with the eye's mapping.
/// Without `planes` the scenes are rendered first, 640x480, one ray a pixel;
/// without `images` they are looked for in ./images and beside the program.
int run_table(const TableCommand& command, const Session& session);

}  // namespace sir::cli
