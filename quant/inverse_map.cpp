#include "quant/inverse_map.h"

#include <algorithm>
#include <limits>

namespace sir::quant {

InverseMap::InverseMap(const Lut& lut)
    : chosen_(lut.chosen), cells_(std::size_t{1} << 3 * (8 - kCellBits), std::int16_t{-1}) {
  for (std::size_t i = 0; i < kLutEntries; ++i) entries_[i] = lut.seen(i);
}

std::int16_t InverseMap::nearest_to_centre(Rgb8 colour) const {
  constexpr int kLast = (1 << kCellBits) - 1;
  // Twice the lengths keep the centre's halves whole.
  const auto twice_centre = [](int inside) { return 2 * (inside & ~kLast) + kLast; };
  const int r = twice_centre(colour.r), g = twice_centre(colour.g), b = twice_centre(colour.b);
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < chosen_; ++i) {
    const int dr = 2 * entries_[i].r - r, dg = 2 * entries_[i].g - g, db = 2 * entries_[i].b - b;
    const int distance = dr * dr + dg * dg + db * db;
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return static_cast<std::int16_t>(best);
}

}  // namespace sir::quant
