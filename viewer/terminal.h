// What the terminal in front of us can show. The thesis has no terminals.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace sir::viewer {

/// The answer to a request for primary device attributes (DA1: "ESC [ c"), as it comes: ESC [ ?
/// numbers c. None where nothing of the kind came within `patience`, and where we may not ask: in
/// the background, or where `descriptor` is no terminal.
///
/// While it waits the terminal is in raw mode, without echo. It is as before when this returns,
/// also after SIGHUP, SIGINT, SIGQUIT, SIGTERM and SIGTSTP, which are held back until then. What
/// was typed meanwhile is lost. Not for two threads at once.
std::optional<std::string> device_attributes(int descriptor, std::chrono::milliseconds patience);

/// Whether such an answer names sixel graphics: attribute 4.
bool has_sixel(std::string_view answer);

/// Asks the terminal that controls this process, /dev/tty.
bool terminal_has_sixel();

/// The width in characters of the terminal at `descriptor`; none where it is no terminal or does
/// not know.
std::optional<int> terminal_columns(int descriptor);

}  // namespace sir::viewer
