// What a file could not hold, refused where it is no file yet.
#pragma once

#include <string>

#include "modeler/command_error.h"
#include "tracer/error.h"

namespace sir::modeler {

/// Does the work; a FileError in it, of a text in memory, becomes a CommandError without the name
/// and the line that no one has seen.
template <typename Work>
void refusing(Work work) {
  try {
    work();
  } catch (const FileError& error) {
    const std::string said = error.what();
    throw CommandError(said.substr(said.find(": ") + 2));
  }
}

}  // namespace sir::modeler
