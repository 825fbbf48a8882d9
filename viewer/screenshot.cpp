#include "viewer/screenshot.h"

#include "viewer/argb.h"

namespace sir::viewer {

std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem) {
  std::filesystem::path path = (folder / (stem + ".png")).lexically_normal();
  for (int number = 2; std::filesystem::exists(path); ++number)
    path.replace_filename(stem + "-" + std::to_string(number) + ".png");
  return path;
}

Planes to_planes(const Frame& frame) {
  Planes planes(frame.size);
  for (std::size_t i = 0; i < frame.words.size(); ++i) planes.set(i, rgb(frame.words[i]));
  return planes;
}

}  // namespace sir::viewer
