// Images as the command line names them: a base name or a PNG file (thesis 3.6).
#pragma once

#include <filesystem>

#include "viewer/image_name.h"

namespace sir::cli {

using viewer::base_name;
using viewer::is_png;
using viewer::load_image;

/// Refuses (FileError) an output that is one of the files of the input: the PNG
/// or a plane, whichever is read, or one of the four files of its scene.
void refuse_input_file(const std::filesystem::path& output, const std::filesystem::path& input);

}  // namespace sir::cli
