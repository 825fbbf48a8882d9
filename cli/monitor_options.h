// --monitor and the options of its tube (thesis 3.4 gives the codes; the tube is our model).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/add_option.h"
#include "eltek/crt.h"

namespace sir::cli {

/// Adds --monitor ideal|crt and what belongs to crt. What it returns is called when the command
/// line has been read: the tube that was asked for, or none for the ideal monitor. It throws
/// CLI::ValidationError for a tube's options without a tube and for scan lines in too few rows.
std::function<std::optional<eltek::CrtOptions>()> add_monitor(CLI::App* app);

/// The tube's numbers in a few lines, without an end of line: phosphors, white, curve, the
/// primaries and white as bytes, effects.
std::string monitor_text(const eltek::Crt& crt);

}  // namespace sir::cli
