// Pictures side by side, as the MA120 shows them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/planes.h"

namespace sir::bench {

/// A picture's name and the part of it to show; the whole where `size` is 0x0.
struct View {
  std::string name;
  int column = 0, row = 0;
  ImageSize size{0, 0};
};

/// Reads NAME or NAME:WxH+X+Y. Throws std::runtime_error.
View view_of(const std::string& text);

/// Writes the images' parts from left to right with white between them: pixels of a part are
/// doubled, the whole is as it is. Throws std::runtime_error for a part that is not in the image,
/// FileError.
void write_side_by_side(const std::filesystem::path& path, const std::vector<Planes>& images,
                        const View& view);

}  // namespace sir::bench
