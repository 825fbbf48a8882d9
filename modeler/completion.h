// What a line that is being typed can go on with.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/interpreter.h"

namespace sir::modeler {

/// What can stand in place of the line from `begin` on.
struct Completion {
  std::size_t begin = 0;
  std::vector<std::string> words;  ///< whole words, in quotes where they must be; in order
  std::vector<std::string> notes;  ///< what each of them stands for; empty: they say it themselves
};

/// The words that fit where the line ends: commands, solids, kinds, operations, files and so on; of
/// the places in a solid's tree those whose number or whose node's name begins so. A folder ends in
/// a slash. Case and accents of what was typed count for nothing, but in names of
/// files.
Completion complete(const Interpreter& interpreter, std::string_view line);

/// What all have in common from their start; whole characters.
std::string common_start(const std::vector<std::string>& words);

}  // namespace sir::modeler
