// Options as CLI11 takes them, read by our own parsers: an error names the
// option and ends in kUsage.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/session.h"
#include "tracer/planes.h"

namespace sir::cli {

/// What the chosen subcommand leaves behind: its work, yet to be done.
using Action = std::function<int(const Session&)>;

/// How the value of an option is written: in short for the help, in full for
/// one who got it wrong.
struct Form {
  std::string brief, full;
};

/// An option whose value `parse` reads; it returns false, and leaves the value
/// alone, where the text is nothing of the kind.
template <typename Value>
CLI::Option* add_parsed(CLI::App* app, const std::string& name, Value& value,
                        bool (*parse)(std::string_view, Value&), const Form& form,
                        const std::string& help) {
  return app
      ->add_option_function<std::string>(
          name,
          [&value, parse, form, name](const std::string& text) {
            if (!parse(text, value))
              throw CLI::ValidationError(name, fmt::format("\"{}\" is not {}", text, form.full));
          },
          help)
      ->type_name(form.brief);
}

/// One of a few words.
template <typename Enum>
CLI::Option* add_choice(CLI::App* app, const std::string& name, Enum& value,
                        const std::map<std::string, Enum>& choices, const std::string& help) {
  std::string names;
  for (const auto& [text, unused] : choices) names += (names.empty() ? "" : "|") + text;
  return app
      ->add_option_function<std::string>(
          name,
          [&value, choices, names, name](const std::string& text) {
            const auto found = choices.find(text);
            if (found == choices.end())
              throw CLI::ValidationError(name, fmt::format("\"{}\" is not one of {}", text, names));
            value = found->second;
          },
          help)
      ->type_name(names);
}

/// A finite number from `least` to `most`; CLI11's own checks let "nan" pass.
CLI::Option* add_number(CLI::App* app, const std::string& name, double& value, double least,
                        double most, const std::string& help);

/// --size WxH.
void add_size(CLI::App* app, ImageSize& size, const std::string& help);

}  // namespace sir::cli
