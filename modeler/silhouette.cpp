#include "modeler/silhouette.h"

#include <cstdint>
#include <memory>
#include <vector>

#include "modeler/view.h"
#include "tracer/camera.h"
#include "tracer/classify.h"
#include "tracer/tiles.h"

namespace sir::modeler {
namespace {

constexpr std::int64_t kNothing = -1;  // surface numbers are not negative

// superfície[x,y] of a region and of the row above it and the column to its left.
struct Surfaces {
  Region region;
  std::vector<std::int64_t> numbers;

  explicit Surfaces(const Region& wanted)
      : region(wanted),
        numbers(static_cast<std::size_t>(wanted.width + 1) *
                    static_cast<std::size_t>(wanted.height + 1),
                kNothing) {}
  std::int64_t& at(int x, int y) {
    const auto row = static_cast<std::size_t>(y - region.y + 1);
    return numbers[row * static_cast<std::size_t>(region.width + 1) +
                   static_cast<std::size_t>(x - region.x + 1)];
  }
};

}  // namespace

Planes silhouette(const Node& tree, const Scene& scene, ImageSize size,
                  const std::stop_token& stop) {
  Planes picture(size);
  const Region region = pixels_of(bounds_in_obs(tree, scene.camera).front(), scene.camera, size);
  if (region.width <= 0 || region.height <= 0) return picture;
  const Solid<double> solid = build_solid<double>(scene);
  const Camera<double> camera(scene.camera);
  Surfaces surfaces(region);
  const auto make_worker = [&]() -> PieceWorker {
    const auto classifier = std::make_shared<Classifier<double>>(solid);
    return [&, classifier](std::int64_t piece) {
      const int y = region.y - 1 + static_cast<int>(piece);
      Boundary<double> first;
      for (int x = region.x - 1; x < region.x + region.width; ++x)
        if (classifier->first(camera.primary_ray(x, y, size), {}, first))
          surfaces.at(x, y) = scene.surfaces[solid.leaves[first.leaf].surfaces[first.face]].number;
    };
  };
  if (!for_each_piece(region.height + 1, 0, make_worker, {}, stop)) return picture;
  for (int y = region.y; y < region.y + region.height; ++y)
    for (int x = region.x; x < region.x + region.width; ++x) {
      const std::int64_t here = surfaces.at(x, y);
      if (here == surfaces.at(x, y - 1) && here == surfaces.at(x - 1, y)) continue;
      picture.set(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x),
                  {255, 255, 255});
    }
  return picture;
}

std::string in_dots(const Planes& picture) {
  // The dots' bits, by row and column of a character.
  constexpr int kBit[4][2] = {{0, 3}, {1, 4}, {2, 5}, {6, 7}};
  std::string text;
  for (int top = 0; top < picture.size.height; top += 4) {
    std::string line;
    std::size_t inked = 0;  // the line up to its last dot
    for (int left = 0; left < picture.size.width; left += 2) {
      unsigned dots = 0;
      for (int y = top; y < std::min(top + 4, picture.size.height); ++y)
        for (int x = left; x < std::min(left + 2, picture.size.width); ++x) {
          const auto pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
              static_cast<std::size_t>(x);
          if (picture.channel[0][pixel] != 0) dots |= 1u << kBit[y - top][x - left];
        }
      if (dots == 0) {
        line += ' ';
        continue;
      }
      // U+2800 + dots in UTF-8.
      line += {'\xE2', static_cast<char>(0xA0 | dots >> 6), static_cast<char>(0x80 | (dots & 63))};
      inked = line.size();
    }
    text += line.substr(0, inked) + "\n";
  }
  return text;
}

}  // namespace sir::modeler
