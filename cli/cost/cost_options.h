// The command line of `sir cost`.
#pragma once

#include "cli/add_option.h"

namespace sir::cli {

/// Adds the subcommand, which leaves its work in `action`.
void add_cost(CLI::App& app, Action& action);

}  // namespace sir::cli
