// A journal's commands once more (the thesis has none).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "modeler/interpreter.h"
#include "modeler/journal_text.h"

namespace sir::modeler {

/// What came of it.
struct Playback {
  std::size_t done = 0;
  std::vector<std::string> failed;  ///< "name:line: reason: command", for each that was refused
};

/// Does the commands after one another, in an interpreter as at the beginning. Where one is refused
/// the others are done all the same; an undo of what was refused takes back nothing else. Throws
/// CommandError where it is interrupted.
Playback play_back(const std::string& name, const Journal& journal, Interpreter& interpreter);

}  // namespace sir::modeler
