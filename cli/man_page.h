// Manual pages: NAME, SYNOPSIS and OPTIONS from what the program parses, so that they are always
// true; the prose from docs/man/.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace sir::cli {

/// What stands at the edges of each page.
struct Edition {
  std::string date, version;
};

/// The page of a subcommand, or of `sir` where `command` is the whole line, in the language of
/// man(7). `prose` is in that language, too: the text of DESCRIPTION, then sections
/// that follow EXIT STATUS, such as FILES and EXAMPLES, and SEE ALSO.
/// Throws std::invalid_argument for a prose that lacks EXAMPLES or SEE ALSO.
std::string man_page(const CLI::App& command, const std::string& prose, const Edition& edition);

}  // namespace sir::cli
