// Where a command's outputs go (thesis 3.6).
#pragma once

#include <filesystem>
#include <optional>

namespace sir::cli {

/// The path of BASE's outputs: in the folder `out`, which is created, or beside
/// BASE.
std::filesystem::path output_base(const std::filesystem::path& base,
                                  const std::optional<std::filesystem::path>& out);

}  // namespace sir::cli
