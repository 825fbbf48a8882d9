#include "modeler/look_files.h"

#include <fmt/format.h>

#include "modeler/command_error.h"
#include "tracer/scene_path.h"

namespace sir::modeler {
namespace {

using Path = std::filesystem::path;

}  // namespace

std::string suffix_of(const Path& file) { return fold_keyword(file.extension().string()); }

bool is_device(const Path& file) {
  std::error_code ignored;
  return std::filesystem::is_other(file, ignored);
}

void require_file_name(const Path& file) {
  const Path name = file.filename();
  if (!name.empty() && name != "." && name != "..") return;
  throw CommandError(in_quotes(file.string()) +
                     (file.empty() ? " is no name of a file" : " is a folder"));
}

Path file_to_write(const Path& file, std::string_view suffix) {
  require_file_name(file);
  const std::string given = suffix_of(file);
  if (given == fold_keyword("." + std::string(suffix)) || is_device(file)) return file;
  for (const char* other :
       {".csg", ".model", ".cam", ".luz", ".sup", ".lut", ".r", ".g", ".b", ".png"})
    if (given == other)
      throw CommandError(fmt::format("{} is the name of another kind of file; this is a .{}",
                                     in_quotes(file.string()), suffix));
  return with_suffix(file, suffix);
}

TextFile file_to_read(const Path& file, std::string_view suffix) {
  std::error_code ignored;
  const bool there = std::filesystem::is_regular_file(file, ignored) ||
                     suffix_of(file) == fold_keyword("." + std::string(suffix));
  return TextFile(there ? file : find_by_suffix(file, suffix));
}

}  // namespace sir::modeler
