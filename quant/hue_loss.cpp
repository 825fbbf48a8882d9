#include "quant/hue_loss.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "quant/ciede2000.h"
#include "quant/grid.h"
#include "quant/image_pair.h"

namespace sir::quant {
namespace {

/// The plane of each pixel.
std::vector<int> planes_of(const Planes& image, const HsvGrid& grid) {
  std::vector<std::uint32_t> cells(image.size.pixels());
  grid.locate(image.channel[0].data(), image.channel[1].data(), image.channel[2].data(), cells);
  std::vector<int> planes(cells.size());
  std::transform(cells.begin(), cells.end(), planes.begin(),
                 [&](std::uint32_t cell) { return grid.plane(grid.point(cell)); });
  return planes;
}

bool neighbours(int plane, int other, int hues) {
  const int apart = std::abs(plane - other);
  return std::min(apart, hues - apart) <= 1;
}

/// Whether each pixel lies in a square of 2x2 pixels that all are set; an image
/// one pixel wide or high has squares as wide or as high as itself.
std::vector<char> in_squares(const std::vector<char>& set, ImageSize size) {
  const auto width = static_cast<std::size_t>(size.width);
  const std::size_t right = size.width > 1 ? 1 : 0, below = size.height > 1 ? width : 0;
  std::vector<char> inside(set.size());
  for (std::size_t i = 0; i + right + below < set.size(); ++i) {
    if (right && (i + 1) % width == 0) continue;
    if (set[i] && set[i + right] && set[i + below] && set[i + right + below])
      inside[i] = inside[i + right] = inside[i + below] = inside[i + right + below] = 1;
  }
  return inside;
}

struct Tally {
  std::uint64_t pixels = 0, moved = 0, gone = 0;
};

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

const char* hue_name(int degrees) {
  static constexpr std::array<const char*, 12> kNames{
      "red",  "orange", "yellow", "chartreuse", "green",   "spring green",
      "cyan", "azure",  "blue",   "violet",     "magenta", "rose"};
  return kNames[static_cast<std::size_t>((degrees + 15) / 30) % kNames.size()];
}

HueLoss hue_loss(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  const HsvGrid grid;
  const int grey = grid.grey_plane();
  const auto before = planes_of(reference, grid), after = planes_of(shown, grid);
  ColourDifference difference;
  std::vector<char> gone(before.size());
  for (std::size_t i = 0; i < gone.size(); ++i)
    gone[i] = before[i] != grey && (after[i] == grey || !neighbours(before[i], after[i], grey)) &&
              difference(reference.at(i), shown.at(i)) >= kPlainToSee;
  gone = in_squares(gone, reference.size);

  std::vector<Tally> tallies(static_cast<std::size_t>(grey) + 1);
  for (std::size_t i = 0; i < before.size(); ++i) {
    Tally& tally = tallies[static_cast<std::size_t>(before[i])];
    ++tally.pixels;
    tally.moved += after[i] != before[i];
    tally.gone += gone[i] != 0;
  }
  HueLoss loss;
  Tally hues;
  for (int plane = 0; plane <= grey; ++plane) {
    const Tally& tally = tallies[static_cast<std::size_t>(plane)];
    if (tally.pixels == 0) continue;
    loss.planes.push_back({plane, tally.pixels, share(tally.moved, tally.pixels)});
    if (plane == grey) continue;
    hues.pixels += tally.pixels;
    hues.moved += tally.moved;
    if (2 * tally.gone >= tally.pixels) loss.alarms.push_back(plane);
  }
  loss.weighted = share(hues.moved, hues.pixels);
  return loss;
}

}  // namespace sir::quant
