// A key with its modifiers, as the viewer's commands name it. The thesis has no keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sir::viewer {

/// What was pressed: a character that the key types without modifiers (letters in lower case), or
/// one of the named keys below, which have numbers past all characters.
struct Key {
  char32_t code = 0;
  bool ctrl = false;
  bool shift = false;  ///< never with characters such as ? and +, which say it themselves
  bool alt = false;
  friend bool operator==(const Key&, const Key&) = default;
};

inline constexpr char32_t kFirstNamedKey = 0x110000;
enum NamedKey : char32_t {
  kEscape = kFirstNamedKey,
  kEnter,
  kTab,
  kBackspace,
  kLeft,
  kRight,
  kUp,
  kDown,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kF1,
  kF5 = kF1 + 4,
  kF11 = kF1 + 10
};

/// Reads "G", "Ctrl+G", "Shift+R", "Page Up", "?". None where it is no key.
std::optional<Key> parse_key(std::string_view text);

/// The same the other way round, for key sheets.
std::string text(const Key& key);

}  // namespace sir::viewer
