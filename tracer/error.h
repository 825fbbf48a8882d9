// The one error type of the libraries (the thesis has none).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sir {

/// Work that could not be done because of what a file holds, or because it
/// cannot be read or written. what() is one line meant for a person:
/// "file:line: reason", or "file: reason" where no line is to blame.
/// Only the program's main catches it, and the viewer, which says what went wrong and stays open.
class FileError : public std::runtime_error {
 public:
  /// `line` counts from 1; 0 means that no single line is to blame.
  FileError(std::string_view file, std::size_t line, std::string_view reason)
      : std::runtime_error(format(file, line, reason)) {}

  /// One that was caught elsewhere, as in another thread, by its what().
  static FileError repeated(const std::string& what) { return FileError(what); }

 private:
  explicit FileError(const std::string& what) : std::runtime_error(what) {}
  static std::string format(std::string_view file, std::size_t line, std::string_view reason) {
    std::string text(file.empty() ? "(empty name)" : file);
    if (line > 0) text += ":" + std::to_string(line);
    return text.append(": ").append(reason);
  }
};

}  // namespace sir
