#include "cli/option_text.h"

#include <algorithm>
#include <sstream>

namespace sir::cli {
namespace {

std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) all.push_back(part);
  return all;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (!option.nonpositional()) return {option.get_name(true, false)};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11 has "N:INT in [1 - 8]" where a range is checked: the form, and the range in words.
void take_type(const std::string& type, OptionText& text) {
  const auto colon = type.find(":INT in ["), unsigned_colon = type.find(":UINT in [");
  const auto at = std::min(colon, unsigned_colon);
  text.value = type.substr(0, at);
  if (at == std::string::npos) return;
  const auto open = type.find('[', at), dash = type.find(" - ", open), close = type.find(']', dash);
  text.help += "; from " + type.substr(open + 1, dash - open - 1) + " to " +
               type.substr(dash + 3, close - dash - 3);
}

// A flag that takes one of a few words has ":{auto,blocks,sixel}".
void take_flag_words(std::string type, OptionText& text) {
  if (!type.starts_with(":{") || !type.ends_with('}')) return;
  text.value_optional = true;
  std::replace(type.begin(), type.end(), ',', '|');
  text.value = type.substr(2, type.size() - 3);
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.names = names_of(option);
  text.positional = !option.nonpositional();
  text.required = option.get_required();
  text.repeated = option.get_expected_max() > 1;
  text.help = option.get_description();
  if (option.get_group() != "Options") text.group = option.get_group();
  const bool is_flag = option.get_items_expected_max() == 0 || option.get_expected_min() == 0;
  if (is_flag) take_flag_words(option.get_type_name(), text);
  else take_type(option.get_type_name(), text);
  if (!text.positional) text.words = words_of(text.value);
  for (const CLI::Option* other : option.get_excludes())
    text.not_beside.push_back(names_of(*other).back());
  std::sort(text.not_beside.begin(), text.not_beside.end());
  return text;
}

}  // namespace

std::vector<std::string> words_of(const std::string& form) {
  constexpr auto kLetters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  std::vector<std::string> words;
  if (form.find('|') == std::string::npos) return words;
  for (const std::string& part : parts(form, '|')) {
    const auto end = std::min(part.find_first_not_of(kLetters), part.size());
    if (end > 0 && (end == part.size() || part[end] == '[')) words.push_back(part.substr(0, end));
  }
  return words;
}

std::vector<OptionText> option_texts(const CLI::App& app) {
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app.get_options()) texts.push_back(text_of(*option));
  return texts;
}

}  // namespace sir::cli
