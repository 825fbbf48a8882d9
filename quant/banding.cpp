#include "quant/banding.h"

#include <cmath>
#include <cstdlib>

#include "quant/ciede2000.h"
#include "quant/image_pair.h"

namespace sir::quant {
namespace {

constexpr int kDacStep = 4;  // levels of a byte from a code of the DAC to the next
constexpr int kReach = 2;    // pixels around

/// The pixels of an image in one direction: lines of `length` pixels, `step`
/// apart in memory, and the first pixels of lines `line_step` apart.
struct Direction {
  int lines, length;
  std::size_t line_step, step;

  std::size_t first(int line) const { return static_cast<std::size_t>(line) * line_step; }
};

Direction rows_of(ImageSize size) {
  return {size.height, size.width, static_cast<std::size_t>(size.width), 1};
}

Direction columns_of(ImageSize size) {
  return {size.width, size.height, 1, static_cast<std::size_t>(size.width)};
}

/// One flag a pixel.
using Mask = std::vector<std::uint8_t>;

/// Clears the pixels that are too steep or bent along the lines of a direction.
void clear_uneven(const std::vector<std::uint8_t>& plane, const Direction& along, Mask& mask) {
  for (int line = 0; line < along.lines; ++line) {
    std::size_t at = along.first(line);
    int before = 0;
    for (int i = 0; i < along.length; ++i, at += along.step) {
      const int after = i + 1 < along.length ? plane[at + along.step] - plane[at] : 0;
      const bool inside = i > 0 && i + 1 < along.length;
      if (std::abs(before) > kDacStep || std::abs(after) > kDacStep ||
          (inside && std::abs(after - before) > kDacStep))
        mask[at] = 0;
      before = after;
    }
  }
}

/// Keeps the pixels that have no cleared one within kReach along the lines.
Mask eroded(const Mask& mask, const Direction& along) {
  Mask kept(mask.size());
  for (int line = 0; line < along.lines; ++line) {
    std::size_t at = along.first(line);
    int run = kReach;  // set pixels up to the one at i + kReach; outside counts as set
    for (int i = -kReach; i < along.length; ++i) {
      const int ahead = i + kReach;
      if (ahead < along.length) {
        const std::size_t pixel = along.first(line) + static_cast<std::size_t>(ahead) * along.step;
        run = mask[pixel] ? run + 1 : 0;
      } else {
        ++run;
      }
      if (i < 0) continue;
      kept[at] = run > 2 * kReach;
      at += along.step;
    }
  }
  return kept;
}

Mask smooth_pixels(const Planes& image) {
  const Direction rows = rows_of(image.size), columns = columns_of(image.size);
  Mask even(image.size.pixels(), 1);
  for (const auto& plane : image.channel) {
    clear_uneven(plane, rows, even);
    clear_uneven(plane, columns, even);
  }
  return eroded(eroded(even, rows), columns);
}

}  // namespace

double banding(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  const Mask smooth = smooth_pixels(reference);
  ColourDifference difference;
  double sum = 0;
  std::size_t pairs = 0;
  for (const Direction& along : {rows_of(shown.size), columns_of(shown.size)}) {
    const auto length = static_cast<std::size_t>(along.length);
    pairs += static_cast<std::size_t>(along.lines) * (length - 1);
    for (int line = 0; line < along.lines; ++line)
      for (std::size_t i = 0; i + 1 < length; ++i) {
        const std::size_t p = along.first(line) + i * along.step, q = p + along.step;
        const Rgb8 before = shown.at(p), after = shown.at(q);
        if (before == after || !smooth[p] || !smooth[q]) continue;
        if (i > 0 && shown.at(p - along.step) != before) continue;
        if (i + 2 < length && shown.at(q + along.step) != after) continue;
        const double added =
            difference(before, after) - difference(reference.at(p), reference.at(q));
        if (added > 0) sum += added * added;
      }
  }
  return pairs == 0 ? 0 : std::sqrt(sum / static_cast<double>(pairs));
}

}  // namespace sir::quant
