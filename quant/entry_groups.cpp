#include "quant/entry_groups.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sir::quant {
namespace {

struct Sums {
  std::array<std::uint64_t, 3> of_bytes{};
  std::uint64_t of_squares = 0, pixels = 0;
};

}  // namespace

std::array<EntryGroup, kLutEntries> entry_groups(const Planes& image,
                                                 std::span<const std::uint8_t> indices) {
  const std::size_t pixels = image.size.pixels();
  if (indices.size() != pixels) throw std::invalid_argument("not one index for each pixel");
  std::array<Sums, kLutEntries> sums;
  std::vector<std::uint32_t> pairs(pixels);  // the index, then the colour's bytes
  for (std::size_t i = 0; i < pixels; ++i) {
    Sums& sum = sums[indices[i]];
    ++sum.pixels;
    pairs[i] = indices[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t byte = image.channel[c][i];
      sum.of_bytes[c] += byte;
      sum.of_squares += byte * byte;
      pairs[i] = pairs[i] << 8 | byte;
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  std::array<EntryGroup, kLutEntries> groups;
  for (const std::uint32_t pair : pairs) ++groups[pair >> 24].colours;
  for (std::size_t entry = 0; entry < kLutEntries; ++entry) {
    const Sums& sum = sums[entry];
    EntryGroup& group = groups[entry];
    group.pixels = sum.pixels;
    if (sum.pixels == 0) continue;
    const auto count = static_cast<double>(sum.pixels);
    double square_of_mean = 0;
    for (int c = 0; c < 3; ++c) {
      group.mean[c] = static_cast<double>(sum.of_bytes[static_cast<std::size_t>(c)]) / count;
      square_of_mean += group.mean[c] * group.mean[c];
    }
    const double variance = static_cast<double>(sum.of_squares) / count - square_of_mean;
    group.spread = group.colours == 1 ? 0 : std::sqrt(std::max(variance, 0.0));
  }
  return groups;
}

std::optional<std::uint8_t> nearest_other(const Lut& lut, std::uint8_t index) {
  const Rgb8 own = lut.seen(index);
  std::optional<std::uint8_t> nearest;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    const int distance = squared_distance(lut.seen(i), own);
    if (distance > 0 && (!nearest || distance < squared_distance(lut.seen(*nearest), own)))
      nearest = static_cast<std::uint8_t>(i);
  }
  return nearest;
}

}  // namespace sir::quant
