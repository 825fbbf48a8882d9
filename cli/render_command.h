// `sir render`: BASE's four files to planes and PNG.
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
  bool stats = false;
};

/// Writes BASE.R, BASE.G, BASE.B and BASE.png; with `stats` a JSON object to
/// standard output. Returns an exit code; throws FileError.
int run_render(const RenderCommand& command, const Session& session);

/// The path of BASE's outputs: in the folder `out`, which is created, or beside
/// BASE.
std::filesystem::path output_base(const std::filesystem::path& base,
                                  const std::optional<std::filesystem::path>& out);

}  // namespace sir::cli
