#include "viewer/key.h"

#include <array>
#include <utility>

namespace sir::viewer {
namespace {

using Name = std::pair<std::string_view, char32_t>;
constexpr std::array kNames{Name{"Esc", kEscape},     Name{"Enter", kEnter},
                            Name{"Tab", kTab},        Name{"Backspace", kBackspace},
                            Name{"Left", kLeft},      Name{"Right", kRight},
                            Name{"Up", kUp},          Name{"Down", kDown},
                            Name{"Page Up", kPageUp}, Name{"Page Down", kPageDown},
                            Name{"Home", kHome},      Name{"End", kEnd},
                            Name{"F1", kF1},          Name{"F5", kF5},
                            Name{"F11", kF11},        Name{"Space", U' '}};

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<Key> parse_key(std::string_view text) {
  Key key;
  for (bool more = true; more;) {
    more = false;
    if (take_prefix(text, "Ctrl+")) more = key.ctrl = true;
    if (take_prefix(text, "Shift+")) more = key.shift = true;
    if (take_prefix(text, "Alt+")) more = key.alt = true;
  }
  for (const auto& [name, code] : kNames)
    if (name == text) key.code = code;
  if (text.size() == 1 && text[0] > ' ' && text[0] <= '~') {
    const char c = text[0];
    key.code = static_cast<char32_t>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  if (key.code == 0) return std::nullopt;
  return key;
}

std::string text(const Key& key) {
  std::string result;
  if (key.ctrl) result += "Ctrl+";
  if (key.alt) result += "Alt+";
  if (key.shift) result += "Shift+";
  for (const auto& [name, code] : kNames)
    if (code == key.code) return result.append(name);
  const auto c = static_cast<char>(key.code);
  return result += (c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
}

}  // namespace sir::viewer
