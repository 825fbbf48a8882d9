// The command lines of `sir paint` and `sir cost`.
#pragma once

#include "cli/add_option.h"

namespace sir::cli {

/// Each adds its subcommand, which leaves its work in `action`.
void add_paint(CLI::App& app, Action& action);
void add_cost(CLI::App& app, Action& action);

}  // namespace sir::cli
