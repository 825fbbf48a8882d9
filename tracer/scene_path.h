// From a base name to the files of an image (thesis 3.6).
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace sir {

/// BASE + "." + suffix; a dot within BASE is kept.
std::filesystem::path with_suffix(const std::filesystem::path& base, std::string_view suffix);

/// The existing file BASE.SUFFIX, the suffix (given in upper case) in upper
/// or lower case, upper case first; none where neither is there.
std::optional<std::filesystem::path> existing_by_suffix(const std::filesystem::path& base,
                                                        std::string_view suffix);

/// The same, but throws FileError that tells where it was looked for.
std::filesystem::path find_by_suffix(const std::filesystem::path& base, std::string_view suffix);

}  // namespace sir
