// The names of files: .CAM, .LUZ, .SUP (thesis 3.6), scripts.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tracer/text_file.h"

namespace sir::modeler {

/// ".csg" of BASE.CSG: the suffix as a keyword, with its dot.
std::string suffix_of(const std::filesystem::path& file);

/// Whether this is no file but a pipe or a device, such as /dev/stdout, which has its name already.
bool is_device(const std::filesystem::path& file);

/// Refuses what surely names a folder (out/, ..), and nothing at all.
void require_file_name(const std::filesystem::path& file);

/// FILE.SUFFIX, or FILE where that is its suffix already or it is a device. `suffix` as it is to be
/// written, without its dot. Throws CommandError for the suffix of another kind of a scene's files
/// and where require_file_name() does.
std::filesystem::path file_to_write(const std::filesystem::path& file, std::string_view suffix);

/// FILE where it is there, else FILE.SUFFIX, in upper or lower case. Throws FileError that says
/// where it was looked for.
TextFile file_to_read(const std::filesystem::path& file, std::string_view suffix);

}  // namespace sir::modeler
