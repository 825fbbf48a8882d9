// Ctrl-C: long work is asked to stop, so that it can leave nothing half done
// (the thesis has none).
#pragma once

#include <stop_token>

namespace sir::cli {

/// Makes SIGINT, SIGTERM and SIGHUP request a stop (a second one ends the
/// program at once, its temporary files removed) and writing to a closed pipe
/// an error instead of a signal. Under nohup, SIGHUP stays ignored.
void install_signal_handlers();

/// A token that is stopped by those signals.
std::stop_token interruption();

/// Whether one has arrived.
bool interrupted();

}  // namespace sir::cli
