#include "quant/banding.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "quant/ciede2000.h"
#include "quant/image_pair.h"

namespace sir::quant {
namespace {

constexpr int kDacStep = 4;  // levels of a byte from a code of the DAC to the next
constexpr int kReach = 2;    // pixels around
constexpr int kStretch = 3;  // pixels of one colour on either side of a false contour

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

/// The steps of an image along the lines of a direction.
class Steps {
 public:
  Steps(const Planes& shown, const Direction& along) : shown_(shown), along_(along) {}

  /// Whether there is a step after pixel i of a line, between even stretches.
  bool even(int line, int i) const {
    const Rgb8 before = at(line, i), after = at(line, i + 1);
    if (before == after) return false;
    for (int k = 1; k < kStretch; ++k) {
      if (i - k >= 0 && at(line, i - k) != before) return false;
      if (i + 1 + k < along_.length && at(line, i + 1 + k) != after) return false;
    }
    return true;
  }

  /// Whether the step goes on in both lines beside; beyond the image it does.
  bool goes_on(int line, int i) const {
    return goes_on_in(line - 1, line, i) && goes_on_in(line + 1, line, i);
  }

 private:
  bool goes_on_in(int beside, int line, int i) const {
    if (beside < 0 || beside >= along_.lines) return true;
    for (int j = std::max(i - 1, 0); j <= i + 1 && j + 1 < along_.length; ++j)
      if (at(beside, j) == at(line, i) && at(beside, j + 1) == at(line, i + 1)) return true;
    return false;
  }

  Rgb8 at(int line, int i) const {
    return shown_.at(along_.first(line) + static_cast<std::size_t>(i) * along_.step);
  }

  const Planes& shown_;
  const Direction& along_;
};

}  // namespace

double banding(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  const Mask smooth = smooth_pixels(reference);
  ColourDifference difference;
  double sum = 0;
  std::size_t pairs = 0;
  for (const Direction& along : {rows_of(shown.size), columns_of(shown.size)}) {
    const Steps steps(shown, along);
    pairs += static_cast<std::size_t>(along.lines) * static_cast<std::size_t>(along.length - 1);
    for (int line = 0; line < along.lines; ++line)
      for (int i = 0; i + 1 < along.length; ++i) {
        const std::size_t p = along.first(line) + static_cast<std::size_t>(i) * along.step,
                          q = p + along.step;
        if (!smooth[p] || !smooth[q] || !steps.even(line, i) || !steps.goes_on(line, i)) continue;
        const double added =
            difference(shown.at(p), shown.at(q)) - difference(reference.at(p), reference.at(q));
        if (added > 0) sum += added * added;
      }
  }
  return pairs == 0 ? 0 : std::sqrt(sum / static_cast<double>(pairs));
}

}  // namespace sir::quant
