// Where the program keeps what is a person's and no scene: what was typed, sessions that were not
// ended (the thesis has none).
#pragma once

#include <filesystem>

namespace sir::modeler {

/// $XDG_STATE_HOME/sir, or ~/.local/state/sir. Empty where there is no home.
std::filesystem::path state_folder();

/// Makes it, for its owner's eyes only; what is there stays as it is. Throws FileError.
void make_state_folder(const std::filesystem::path& folder);

}  // namespace sir::modeler
