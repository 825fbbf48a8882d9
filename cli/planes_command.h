// sir planes: planes to PNG and back (thesis 3.6.4).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/session.h"
#include "tracer/planes.h"

namespace sir::cli {

struct PlanesOptions {
  std::filesystem::path input;                  ///< BASE, or FILE.png for the way back
  ImageSize size;                               ///< of planes that are read
  std::optional<std::filesystem::path> output;  ///< -o: the PNG file, or the planes' base name
  std::optional<std::filesystem::path> folder;  ///< --out: created where it is missing
};

/// BASE -> BASE.png, or FILE.png -> FILE.R, FILE.G and FILE.B; for planes the
/// size, which they do not hold, goes to standard output. Inputs are never
/// overwritten. Returns an exit code; throws FileError.
int run_planes(const PlanesOptions& options, const Session& session);

}  // namespace sir::cli
