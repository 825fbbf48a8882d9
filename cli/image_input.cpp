#include "cli/image_input.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "tracer/atomic_file.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"

namespace sir::cli {

bool is_png(const std::filesystem::path& input) {
  std::string suffix = input.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return suffix == ".png";
}

std::filesystem::path base_name(const std::filesystem::path& input) {
  return is_png(input) ? std::filesystem::path(input).replace_extension() : input;
}

Planes load_image(const std::filesystem::path& input, ImageSize size) {
  return is_png(input) ? viewer::read_png(input) : read_planes(input, size);
}

void refuse_input_file(const std::filesystem::path& output, const std::filesystem::path& input) {
  const auto refuse = [&](std::initializer_list<const char*> suffixes) {
    for (const char* suffix : suffixes)
      refuse_same_file(output, with_suffix(base_name(input), suffix));
  };
  if (is_png(input)) refuse_same_file(output, input);
  else refuse({"R", "G", "B", "r", "g", "b"});
  // A slip of the suffix must not cost the scene that the image came from.
  refuse({"CSG", "CAM", "LUZ", "SUP", "csg", "cam", "luz", "sup"});
}

}  // namespace sir::cli
