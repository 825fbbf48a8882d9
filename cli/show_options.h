// The command line of `sir show`.
#pragma once

#include "cli/add_option.h"

namespace sir::cli {

/// Adds the subcommand, which leaves its work in `action`.
void add_show(CLI::App& app, Action& action);

}  // namespace sir::cli
