// `sir render`: BASE's four files to planes and PNG (SIR, thesis 3.3).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/session.h"
#include "tracer/render.h"

namespace sir::cli {

struct RenderCommand {
  std::filesystem::path base;
  std::optional<std::filesystem::path> out;  ///< folder; without one, beside BASE
  RenderOptions options;
  bool png = true;
  bool progressive = false;  ///< BASE.png is the picture so far, after each stage
  bool stats = false;
  bool resume = false;    ///< continue from BASE.tiles
  double keep_after = 5;  ///< seconds from which on finished tiles are kept there
  std::optional<std::filesystem::path> hesitation;  ///< PNG of the hesitating pixels
};

/// Writes BASE.R, BASE.G, BASE.B and BASE.png (with `progressive` many times, the last
/// like the planes); with `hesitation` its picture, and
/// a table of nodes to standard output; with `stats` a JSON object instead, which
/// then holds the table. Returns an exit code; throws FileError.
int run_render(const RenderCommand& command, const Session& session);

}  // namespace sir::cli
