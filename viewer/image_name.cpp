#include "viewer/image_name.h"

#include <algorithm>
#include <array>
#include <string>

#include "viewer/png_file.h"

namespace sir::viewer {
namespace {

// In lower case.
std::string suffix_of(const std::filesystem::path& input) {
  std::string suffix = input.extension().string();
  for (char& letter : suffix)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return suffix;
}

}  // namespace

bool is_png(const std::filesystem::path& input) { return suffix_of(input) == ".png"; }

std::filesystem::path base_name(const std::filesystem::path& input) {
  return is_png(input) ? std::filesystem::path(input).replace_extension() : input;
}

std::filesystem::path given_base(const std::filesystem::path& input) {
  static constexpr std::array kOfAnImage{".csg", ".cam", ".luz", ".sup", ".r", ".g", ".b"};
  std::error_code ignored;
  if (std::ranges::find(kOfAnImage, suffix_of(input)) == kOfAnImage.end() ||
      !std::filesystem::is_regular_file(input, ignored))
    return input;
  return std::filesystem::path(input).replace_extension();
}

Planes load_image(const std::filesystem::path& input, ImageSize size) {
  return is_png(input) ? read_png(input) : read_planes(input, size);
}

}  // namespace sir::viewer
