// Waiting for a person and for Ctrl-C at once (the thesis has neither).
#pragma once

namespace sir::cli {

/// Waits until there is something to read at the descriptor, its end included; false where a signal
/// has asked to stop, also one that came just before.
bool wait_for_input(int descriptor);

}  // namespace sir::cli
