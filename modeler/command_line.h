// A line of a script or of the prompt as words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sir::modeler {

/// Words are separated by white space. Quotes keep white space and # within a word; in them \" is a
/// quote and \\ a backslash. # outside of quotes begins a comment. Throws CommandError where a
/// quote is not closed.
std::vector<std::string> split_words(std::string_view line);

/// The line without its comment and the white space around it.
std::string_view without_comment(std::string_view line);

/// A word as it must be written to be read as one: as it is, or in quotes.
std::string as_word(std::string_view text);

/// The last word of a line that is still being written.
struct UnfinishedWord {
  std::size_t begin = 0;            ///< where it begins in the line, its quote included
  std::string text;                 ///< what it says so far
  bool quoted = false;              ///< it began with a quote that is still open
  std::vector<std::string> before;  ///< the words before it
  bool in_comment = false;          ///< there is nothing to be completed
};
UnfinishedWord unfinished_word(std::string_view line);

}  // namespace sir::modeler
