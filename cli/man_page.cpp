#include "cli/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/option_text.h"

namespace sir::cli {
namespace {

// Text as it reads, where the language has a meaning of its own for \ and -.
std::string plain(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\\') out += "\\e";
    else if (letter == '-') out += "\\-";
    else out += letter;
  }
  return out;
}

// Lines of at most 72 letters, none of which begins like a request.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 72;
  std::string out, line;
  std::istringstream in(text);
  const auto end_line = [&] {
    if (line.starts_with('.') || line.starts_with('\'')) out += "\\&";
    out += line + "\n";
    line.clear();
  };
  for (std::string word; in >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) end_line();
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) end_line();
  return out;
}

// A sentence of what the help has without its capital letter and its end. Names and what stands
// before a colon, such as the method that an option belongs to, keep their first letter.
std::string sentence(std::string text) {
  const std::string first = text.substr(0, text.find_first_of(" ,;"));
  if (!first.empty() && std::all_of(first.begin(), first.end(),
                                    [](char letter) { return letter >= 'a' && letter <= 'z'; }))
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string upper(std::string text) {
  for (char& letter : text)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

std::string form_of(const OptionText& option) {
  std::string form = "\\fB" + plain(option.names.front()) + "\\fR";
  for (std::size_t i = 1; i < option.names.size(); ++i)
    form += ", \\fB" + plain(option.names[i]) + "\\fR";
  if (option.value_optional) return form + "[=\\fI" + plain(option.value) + "\\fR]";
  return option.value.empty() ? form : form + " \\fI" + plain(option.value) + "\\fR";
}

std::string entry(const OptionText& option) {
  std::string help = sentence(option.help);
  if (option.required && !option.positional) help += " Required.";
  if (!option.not_beside.empty())
    help += fmt::format(" Not with {}.", fmt::join(option.not_beside, " or "));
  const std::string form =
      option.positional ? "\\fI" + plain(option.names.front()) + "\\fR" : form_of(option);
  return ".TP\n" + form + "\n" + wrapped(plain(help));
}

std::string synopsis(const CLI::App& command, const std::vector<OptionText>& options) {
  std::string text = ".B " + plain(command.get_parent() ? "sir " + command.get_name() : "sir") +
                     "\n[\\fIoption\\fR ...]\n";
  if (!command.get_parent()) return text + "\\fIcommand\\fR\n[\\fIargument\\fR ...]\n";
  for (const OptionText& option : options) {
    if (!option.positional && option.required) text += form_of(option) + "\n";
    if (!option.positional) continue;
    const std::string name =
        "\\fI" + plain(option.names.front()) + "\\fR" + (option.repeated ? " ..." : "");
    text += (option.required ? name : "[" + name + "]") + "\n";
  }
  return text;
}

std::string commands(const CLI::App& app) {
  std::string text = ".SH COMMANDS\n";
  for (const CLI::App* sub : subcommands(app))
    text += ".TP\n\\fBsir\\-" + plain(sub->get_name()) + "\\fR(1)\n" +
            wrapped(plain(sentence(sub->get_description())));
  return text;
}

std::string options_section(const std::vector<OptionText>& options) {
  std::string text = ".SH OPTIONS\n", group;
  for (const OptionText& option : options)
    if (option.positional) text += entry(option);
  for (const OptionText& option : options) {
    if (option.positional) continue;
    if (option.group != group) {
      group = option.group;
      text += ".SS \"" + plain(group.empty() ? "Others" : group) + "\"\n";
    }
    text += entry(option);
  }
  return text;
}

// The ends that a command can come to; 3 is of those that are asked for a threshold.
std::string exit_status(const std::vector<OptionText>& options) {
  std::string text =
      ".SH EXIT STATUS\n"
      ".TP\n0\nDone.\n"
      ".TP\n1\nBad input or failed work; what is wrong is said on standard error, with file and\n"
      "line where it is in a file.\n"
      ".TP\n2\nWrong usage.\n";
  if (std::any_of(options.begin(), options.end(), [](const OptionText& option) {
        return option.help.find("exit 3") != std::string::npos;
      }))
    text += ".TP\n3\nA threshold that was asked for is not met.\n";
  return text + ".TP\n130\nInterrupted.\n";
}

}  // namespace

std::string man_page(const CLI::App& command, const std::string& prose, const Edition& edition) {
  const auto sections = prose.find(".SH ");
  if (prose.find(".SH EXAMPLES\n") == std::string::npos ||
      prose.find(".SH SEE ALSO\n") == std::string::npos)
    throw std::invalid_argument("lacks EXAMPLES or SEE ALSO");
  const bool is_sub = command.get_parent() != nullptr;
  const std::string name = is_sub ? "sir-" + command.get_name() : "sir";
  std::string about = command.get_description();
  if (about.ends_with('.')) about.pop_back();
  const std::vector<OptionText> options = option_texts(command);
  return fmt::format(".TH {} 1 {} \"sir {}\" SIR\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}",
                     plain(upper(name)), edition.date, edition.version, plain(name), plain(about),
                     synopsis(command, options)) +
         ".SH DESCRIPTION\n" + prose.substr(0, sections) +
         (is_sub ? std::string() : commands(command)) + options_section(options) +
         exit_status(options) + prose.substr(sections);
}

}  // namespace sir::cli
