#include "cli/output_path.h"

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

}  // namespace sir::cli
