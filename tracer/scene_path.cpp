#include "tracer/scene_path.h"

#include <string>

#include "tracer/error.h"

namespace sir {
namespace {

std::string in_lower_case(std::string_view suffix) {
  std::string lower(suffix);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

}  // namespace

std::filesystem::path with_suffix(const std::filesystem::path& base, std::string_view suffix) {
  return std::filesystem::path(base) += "." + std::string(suffix);
}

std::optional<std::filesystem::path> existing_by_suffix(const std::filesystem::path& base,
                                                        std::string_view suffix) {
  std::error_code ignored;
  for (auto path : {with_suffix(base, suffix), with_suffix(base, in_lower_case(suffix))})
    if (std::filesystem::exists(path, ignored)) return path;
  return std::nullopt;
}

std::filesystem::path find_by_suffix(const std::filesystem::path& base, std::string_view suffix) {
  if (auto path = existing_by_suffix(base, suffix)) return *std::move(path);
  const std::string upper = with_suffix(base, suffix).string();
  const std::string lower = with_suffix(base, in_lower_case(suffix)).string();
  throw FileError(upper, 0, "is missing (looked for " + upper + " and " + lower + ")");
}

}  // namespace sir
