#include "quant/inverse_map.h"

#include <limits>
#include <stdexcept>

namespace sir::quant {

InverseMap::InverseMap(const Lut& lut, const IndexSet& reserved)
    : cells_(std::size_t{1} << 3 * (8 - kCellBits), std::int16_t{-1}) {
  if (reserved.all()) throw std::invalid_argument("a LUT of reserved entries only");
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i]) continue;
    entries_.push_back({lut.seen(i), static_cast<std::int16_t>(i)});
    if (i + 1 >= lut.chosen) break;  // those behind it repeat it
  }
}

std::int16_t InverseMap::nearest_to_centre(Rgb8 colour) const {
  constexpr int kLast = (1 << kCellBits) - 1;
  // Twice the lengths keep the centre's halves whole.
  const auto twice_centre = [](int inside) { return 2 * (inside & ~kLast) + kLast; };
  const int r = twice_centre(colour.r), g = twice_centre(colour.g), b = twice_centre(colour.b);
  std::int16_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (const auto& [entry, index] : entries_) {
    const int dr = 2 * entry.r - r, dg = 2 * entry.g - g, db = 2 * entry.b - b;
    const int distance = dr * dr + dg * dg + db * db;
    if (distance < least) {
      least = distance;
      best = index;
    }
  }
  return best;
}

}  // namespace sir::quant
