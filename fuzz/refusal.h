// What every reader promises of a file that it refuses.
#pragma once

#include <string_view>

#include "tracer/error.h"
#include "tracer/text_file.h"

namespace sir::fuzz {

/// Fails unless the message is one line for a person: "name: reason", or "name:line: reason" with a
/// line that the text has; UTF-8 without control characters.
void check_refusal(const FileError& error, std::string_view name, std::string_view text);

/// Runs read(file) on the text as a file of this name. False where it is refused, as it should be.
template <typename Read>
bool accepts(std::string_view name, std::string_view text, const Read& read) {
  try {
    TextFile file{std::string(name), std::string(text)};
    read(file);
    return true;
  } catch (const FileError& error) {
    check_refusal(error, name, text);
    return false;
  }
}

}  // namespace sir::fuzz
