// sir model: the modeler of scenes, from scripts and at a prompt (thesis 3.2).
#pragma once

#include <filesystem>
#include <optional>

#include "cli/add_option.h"
#include "modeler/interpreter.h"

namespace sir::cli {

struct ModelOptions {
  std::optional<std::filesystem::path> script;  ///< "-": standard input
  std::optional<std::filesystem::path> from;    ///< a scene that is turned into a script, or opened
  std::optional<std::string> recover;           ///< a session to begin with; "": the last one
  bool window = false;                          ///< what there is then is worked on in a window
};

/// Does the commands of a script or of standard input, or asks for them where that is a terminal;
/// with `from` prints the script that makes BASE.CSG. Returns an exit code. Throws FileError, with
/// the script's name and the line where a command of it cannot be done.
int run_model(const ModelOptions& options, const Session& session);

/// What the interpreter needs of this program: PNG, characters, Ctrl-C.
modeler::Outlet make_outlet();

/// Adds the subcommand, which leaves its work in `action`.
void add_model(CLI::App& app, Action& action);

}  // namespace sir::cli
