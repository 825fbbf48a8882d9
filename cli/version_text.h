// What `sir --version` says: the version, and how this program was built.
#pragma once

#include <string>

namespace sir::cli {

/// The version's number alone.
std::string version();

/// Lines: "sir VERSION", then compiler, flags, sanitizers, what it was built with, the libraries'
/// versions and the instruction set that is used on this machine.
std::string version_text();

}  // namespace sir::cli
