// What is wrong with a command, before anyone knows where the command stood.
#pragma once

#include <stdexcept>
#include <string>

namespace sir::modeler {

/// A command that cannot be done; nothing has changed. what() is one line for a person. In a
/// script it becomes a FileError with the script's name and the line (see script.h), at the prompt
/// it is said as it is.
class CommandError : public std::runtime_error {
 public:
  explicit CommandError(const std::string& reason) : std::runtime_error(reason) {}
};

}  // namespace sir::modeler
