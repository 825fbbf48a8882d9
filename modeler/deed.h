// A command that was done, with all that is needed to do it again on another day. The thesis's
// modeler forgets (3.2).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir::modeler {

/// What a command read, as it was then. Text in UTF-8.
struct TextRead {
  std::string file;
  std::string text;
};

/// Of what a command hangs on, Interpreter's state has all but this.
struct Deed {
  std::string command;
  /// The camera was in a hand that had moved it already: `undo camera` takes back both as one.
  bool in_hand = false;
  /// The camera that had been made up, where that happened outside of a command: who draws asks for
  /// it. Outer none: nothing of the kind; inner none: it was given up.
  std::optional<std::optional<CameraFile>> made_up;
  std::vector<TextRead> files;  ///< in the order in which they were read
  std::size_t undoable = 0;     ///< commands, after this one
};

}  // namespace sir::modeler
