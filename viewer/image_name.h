// Images as people name them: a base name or a PNG file (thesis 3.6).
#pragma once

#include <filesystem>

#include "tracer/planes.h"

namespace sir::viewer {

/// Whether the name ends in .png, in any case.
bool is_png(const std::filesystem::path& input);

/// FILE.png -> FILE; any other name is a base name already and stays as it is.
std::filesystem::path base_name(const std::filesystem::path& input);

/// An input as it was meant: the name of one of a scene's files or planes gives its base;
/// anything else stays as it is.
std::filesystem::path given_base(const std::filesystem::path& input);

/// Reads FILE.png, sample values as stored, or the planes BASE.R, BASE.G and
/// BASE.B, which have `size` (a PNG tells its own). Throws FileError.
Planes load_image(const std::filesystem::path& input, ImageSize size);

}  // namespace sir::viewer
