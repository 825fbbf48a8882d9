// Images as the command line names them: a base name or a PNG file (thesis 3.6).
#pragma once

#include <filesystem>

#include "tracer/planes.h"

namespace sir::cli {

/// Whether the name ends in .png, in any case.
bool is_png(const std::filesystem::path& input);

/// FILE.png -> FILE; any other name is a base name already and stays as it is.
std::filesystem::path base_name(const std::filesystem::path& input);

/// Reads FILE.png, sample values as stored, or the planes BASE.R, BASE.G and
/// BASE.B, which have `size` (a PNG tells its own). Throws FileError.
Planes load_image(const std::filesystem::path& input, ImageSize size);

/// Refuses (FileError) an output that is one of the files of the input: the PNG
/// or a plane, whichever is read, or one of the four files of its scene.
void refuse_input_file(const std::filesystem::path& output, const std::filesystem::path& input);

}  // namespace sir::cli
