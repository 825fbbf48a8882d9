#include "bench/quantizers_side.h"

#include <cstdio>
#include <stdexcept>

#include "viewer/png_file.h"

namespace sir::bench {
namespace {

constexpr int kGap = 4;  // white pixels between images

std::size_t index(ImageSize size, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
         static_cast<std::size_t>(column);
}

}  // namespace

View view_of(const std::string& text) {
  View view;
  const std::size_t colon = text.find(':');
  view.name = text.substr(0, colon);
  if (colon == std::string::npos) return view;
  int end = 0;
  const std::string part = text.substr(colon + 1);
  const int read = std::sscanf(part.c_str(), "%dx%d+%d+%d%n", &view.size.width, &view.size.height,
                               &view.column, &view.row, &end);
  if (read != 4 || static_cast<std::size_t>(end) != part.size() || view.size.width < 1 ||
      view.size.height < 1)
    throw std::runtime_error("not NAME or NAME:WxH+X+Y: " + text);
  return view;
}

void write_side_by_side(const std::filesystem::path& path, const std::vector<Planes>& images,
                        const View& view) {
  const bool whole = view.size == ImageSize{0, 0};
  const ImageSize all = images.at(0).size, part = whole ? all : view.size;
  if (view.column < 0 || view.row < 0 || view.column > all.width - part.width ||
      view.row > all.height - part.height)
    throw std::runtime_error("the part to show of " + view.name + " is not in the image");
  const int times = whole ? 1 : 2;
  const int step = part.width * times + kGap;
  Planes sheet(ImageSize{step * static_cast<int>(images.size()) - kGap, part.height * times});
  for (auto& plane : sheet.channel) plane.assign(plane.size(), 255);
  int left = 0;
  for (const Planes& image : images) {
    for (int row = 0; row < part.height * times; ++row)
      for (int column = 0; column < part.width * times; ++column)
        sheet.set(index(sheet.size, left + column, row),
                  image.at(index(all, view.column + column / times, view.row + row / times)));
    left += step;
  }
  viewer::write_rgb_png(path, sheet);
}

}  // namespace sir::bench
