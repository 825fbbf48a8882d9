// What a FileError says.
#pragma once

#include <string>

#include "tracer/error.h"

namespace sir::test {

/// The message of the FileError that `action` throws; "no error" without one.
template <typename Action>
std::string reason_of(Action action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace sir::test
