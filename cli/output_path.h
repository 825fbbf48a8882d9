// Where a command's outputs go (thesis 3.6).
#pragma once

#include <filesystem>
#include <optional>

namespace sir::cli {

/// The path of BASE's outputs: in the folder `out`, which is created, or beside
/// BASE.
std::filesystem::path output_base(const std::filesystem::path& base,
                                  const std::optional<std::filesystem::path>& out);

/// Refuses (FileError) to write a picture to a name that means something else: a
/// plane, a LUT, a file of a scene.
void require_picture_name(const std::filesystem::path& path);

/// Whether two names are of one file, there or not yet.
bool same_place(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace sir::cli
