#include "cli/output_path.h"

#include <cctype>

#include "tracer/error.h"

namespace sir::cli {

std::filesystem::path output_base(const std::filesystem::path& base,
                                  const std::optional<std::filesystem::path>& out) {
  if (!out) return base;
  std::error_code failure;
  std::filesystem::create_directories(*out, failure);
  if (failure || !std::filesystem::is_directory(*out))
    throw FileError(out->string(), 0,
                    "cannot be made a folder" + (failure ? ": " + failure.message() : ""));
  return *out / base.filename();
}

void require_picture_name(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  for (char& letter : suffix) letter = static_cast<char>(std::toupper(letter));
  for (const char* other : {".R", ".G", ".B", ".LUT", ".CSG", ".CAM", ".LUZ", ".SUP"})
    if (suffix == other)
      throw FileError(path.string(), 0,
                      "is the name of a plane, a LUT or a scene's file; a picture is PNG");
}

bool same_place(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(a), ignored) ==
         std::filesystem::weakly_canonical(std::filesystem::absolute(b), ignored);
}

}  // namespace sir::cli
