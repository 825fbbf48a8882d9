#include "fuzz/refusal.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

#include "fuzz/target.h"

namespace sir::fuzz {
namespace {

// Length of the character of UTF-8 that the text begins with; 0: none. Written for this check
// alone, so that it does not lean on what it checks.
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80                      ? 1
                             : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                             : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                             : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                                 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return length;
}

}  // namespace

void check_refusal(const FileError& error, std::string_view name, std::string_view text) {
  std::string_view said = error.what();
  for (std::string_view rest = said; !rest.empty();) {
    const std::size_t length = character(rest);
    require(length > 0, "an error's message is UTF-8");
    const bool control =
        static_cast<unsigned char>(rest[0]) < 0x20 || rest[0] == 0x7F ||
        (length == 2 && rest[0] == '\xC2' && static_cast<unsigned char>(rest[1]) < 0xA0);
    require(!control, "an error's message is one line without control characters");
    rest.remove_prefix(length);
  }
  require(said.starts_with(name), "an error names its file: " + std::string(said));
  said.remove_prefix(name.size());
  if (!said.starts_with(": ")) {
    require(said.starts_with(":"), "an error names its line: " + std::string(said));
    std::size_t line = 0;
    const auto [end, code] = std::from_chars(said.data() + 1, said.data() + said.size(), line);
    const auto lines = static_cast<std::size_t>(1 + std::count(text.begin(), text.end(), '\n'));
    require(code == std::errc{} && line >= 1 && line <= lines, "a refusal's line is in the file");
    said.remove_prefix(static_cast<std::size_t>(end - said.data()));
  }
  require(said.starts_with(": ") && said.size() > 2, "an error gives a reason");
}

}  // namespace sir::fuzz
