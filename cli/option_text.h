// An option in words, for what is written about it: manual pages and completions.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sir::cli {

struct OptionText {
  std::vector<std::string> names;  ///< as typed, -h before --help; of a positional its one name
  std::string value;               ///< how its value is written, as in the help; empty for a flag
  bool positional = false;
  bool required = false;
  bool repeated = false;
  bool value_optional = false;          ///< the value comes after "=" or not at all
  std::vector<std::string> words;       ///< values that can be typed as they stand
  std::string help;                     ///< with its range
  std::string group;                    ///< the heading it stands under; empty for the usual one
  std::vector<std::string> not_beside;  ///< names of options that exclude it
};

/// The options, the positional ones among them, in the order in which they were added.
std::vector<OptionText> option_texts(const CLI::App& app);

/// The words of a value's form, as "none|adaptive[:T]|LIST" has none and adaptive.
std::vector<std::string> words_of(const std::string& form);

}  // namespace sir::cli
