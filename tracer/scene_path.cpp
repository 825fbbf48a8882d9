#include "tracer/scene_path.h"

#include <string>

#include "tracer/error.h"

namespace sir {

std::filesystem::path with_suffix(const std::filesystem::path& base, std::string_view suffix) {
  return std::filesystem::path(base) += "." + std::string(suffix);
}

std::filesystem::path find_by_suffix(const std::filesystem::path& base, std::string_view suffix) {
  std::string lower(suffix);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  auto upper_path = with_suffix(base, suffix);
  auto lower_path = with_suffix(base, lower);
  std::error_code ignored;
  if (std::filesystem::exists(upper_path, ignored)) return upper_path;
  if (std::filesystem::exists(lower_path, ignored)) return lower_path;
  throw FileError(
      upper_path.string(), 0,
      "is missing (looked for " + upper_path.string() + " and " + lower_path.string() + ")");
}

}  // namespace sir
