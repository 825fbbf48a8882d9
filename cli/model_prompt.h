// The modeler's prompt: a person, line by line (the thesis's modeler had menus, 3.2).
#pragma once

#include <optional>
#include <string>

#include "cli/session.h"
#include "modeler/interpreter.h"

namespace sir::cli {

/// The command that brings back a session; "": the last one.
std::string recover_line(const std::string& which);

/// Reads commands from the terminal and does them; what is wrong with one is said, and changes
/// nothing. Who leaves with solids that are not saved is warned once. The session is kept as it
/// goes on (modeler/keeper.h); `recover`: the one to begin with, as of recover_line(). Returns
/// an exit code. Throws FileError.
int run_prompt(modeler::Interpreter& interpreter, const Session& session,
               const std::optional<std::string>& recover);

}  // namespace sir::cli
