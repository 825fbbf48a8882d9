// The modeler's prompt: a person, line by line (the thesis's modeler had menus, 3.2).
#pragma once

#include "cli/session.h"
#include "modeler/interpreter.h"

namespace sir::cli {

/// Reads commands from the terminal and does them; what is wrong with one is said, and changes
/// nothing. Who leaves with solids that are not saved is warned once. Returns an exit code.
int run_prompt(modeler::Interpreter& interpreter, const Session& session);

}  // namespace sir::cli
