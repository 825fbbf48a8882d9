// `sir check` and `sir trace`: looking into a scene without rendering
// it (thesis 3.6 and 2.4.2).
#pragma once

#include <filesystem>

#include "cli/session.h"
#include "tracer/render.h"

namespace sir::cli {

/// Reads BASE's four files and prints what the scene holds.
int run_check(const std::filesystem::path& base, const Session& session);

struct TraceCommand {
  std::filesystem::path base;
  int i = 0, j = 0;  ///< column and row of the pixel, from the top left
  RenderOptions options;
};

/// Prints the tree of the pixel's rays and surfaces (2.4.2).
int run_trace(const TraceCommand& command, const Session& session);

}  // namespace sir::cli
