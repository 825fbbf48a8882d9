// The whole command line: what `sir` parses, and what its manual pages and the shell's completion
// are made of.
#pragma once

#include <vector>

#include "cli/add_option.h"

namespace sir::cli {

/// Gives `app` the global options, which are kept in `session`, and all subcommands; the one that
/// is chosen leaves its work in `action`. All three must live as long as the parsing.
void add_all(CLI::App& app, Session& session, Action& action);

/// The subcommands, in the order of --help.
std::vector<const CLI::App*> subcommands(const CLI::App& app);

}  // namespace sir::cli
