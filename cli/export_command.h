// `sir export`: a scene for another program.
#pragma once

#include <filesystem>

#include "cli/session.h"
#include "interchange/pov_export.h"

namespace sir::cli {

struct ExportCommand {
  std::filesystem::path base;
  std::filesystem::path pov;  ///< the file to write, for POV-Ray 3.7
  PovOptions options;
};

/// Writes the file. Returns an exit code; throws FileError, also where the file
/// is one of BASE's four.
int run_export(const ExportCommand& command, const Session& session);

}  // namespace sir::cli
