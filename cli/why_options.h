// The command line of `sir why`.
#pragma once

#include "cli/add_option.h"

namespace sir::cli {

/// Adds the subcommand, which leaves its work in `action`.
void add_why(CLI::App& app, Action& action);

}  // namespace sir::cli
