// Completion of `sir` in bash, made from what the program parses.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace sir::cli {

/// A script for bash 4.4 or later, with or without the package bash-completion: subcommands,
/// options, the words that an option takes, and files by their suffix.
std::string completion_script(const CLI::App& app);

}  // namespace sir::cli
