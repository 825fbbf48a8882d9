#include "quant/nearest.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "quant/colour_memory.h"
#include "quant/inverse_map.h"

namespace sir::quant {
namespace {

constexpr int square(int x) { return x * x; }

/// The entries that may be taken, in their order.
struct Entries {
  std::array<Rgb8, kLutEntries> colour;
  std::array<std::uint8_t, kLutEntries> index;
  std::size_t count = 0;
};

Entries entries_of(const Lut& lut, const IndexSet& reserved) {
  if (reserved.all()) throw std::invalid_argument("a LUT of reserved entries only");
  Entries entries;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i]) continue;
    entries.colour[entries.count] = lut.seen(i);
    entries.index[entries.count++] = static_cast<std::uint8_t>(i);
  }
  return entries;
}

std::uint8_t nearest_of(Rgb8 colour, const Entries& entries) {
  std::size_t best = 0;
  int best_distance = 3 * square(255) + 1;
  for (std::size_t i = 0; i < entries.count; ++i) {
    const Rgb8 entry = entries.colour[i];
    const int distance =
        square(entry.r - colour.r) + square(entry.g - colour.g) + square(entry.b - colour.b);
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  return entries.index[best];
}

/// Distance and index in one number, so that the least of them is the nearest
/// entry, the lowest index among equals. Distances are below 2^18.
constexpr std::uint32_t ranked(int r, int g, int b, std::uint8_t index) {
  return static_cast<std::uint32_t>(square(r) + square(g) + square(b)) << 8 | index;
}

}  // namespace

std::uint8_t nearest_entry(Rgb8 colour, const Lut& lut, const IndexSet& reserved) {
  return nearest_of(colour, entries_of(lut, reserved));
}

std::vector<std::uint8_t> map_exhaustively(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved) {
  const Entries entries = entries_of(lut, reserved);
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = nearest_of(image.at(i), entries);
  return indices;
}

std::vector<std::uint8_t> map_to_lut(const Planes& image, const Lut& lut, Mapping mapping,
                                     const IndexSet& reserved) {
  std::vector<std::uint8_t> indices(image.size.pixels());
  if (mapping == Mapping::approximate) {
    InverseMap map(lut, reserved);
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = map(image.at(i));
    return indices;
  }
  NearestSearch search(lut, reserved);
  ColourMemory memory;
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = memory(image.at(i), search);
  return indices;
}

NearestSearch::Cubes::Cubes(int bits) : shift(bits), ranges(std::size_t{1} << 3 * (8 - bits)) {}

NearestSearch::Range& NearestSearch::Cubes::around(Rgb8 colour) {
  const int side = 8 - shift;
  return ranges[static_cast<std::size_t>(((colour.r >> shift) << 2 * side) +
                                         ((colour.g >> shift) << side) + (colour.b >> shift))];
}

NearestSearch::NearestSearch(const Lut& lut, const IndexSet& reserved)
    : levels_{Cubes(5), Cubes(4)} {
  const Entries entries = entries_of(lut, reserved);
  const auto first = entries.colour.begin();
  for (std::size_t i = 0; i < entries.count; ++i) {
    const Rgb8 colour = entries.colour[i];
    const auto here = first + static_cast<std::ptrdiff_t>(i);
    if (std::find(first, here, colour) != here)
      continue;  // an equal entry of lower index always comes first
    candidates_.push_back({colour.r, colour.g, colour.b, entries.index[i]});
  }
  all_.count = static_cast<std::uint32_t>(candidates_.size());
}

std::uint8_t NearestSearch::operator()(Rgb8 colour) {
  const Range range = listed(colour, levels_.size() - 1);
  std::uint32_t best = 0xFFFFFFFF;
  const Candidate* const first = candidates_.data() + range.first;
  for (const Candidate* entry = first; entry != first + range.count; ++entry)
    best = std::min(
        best, ranked(entry->r - colour.r, entry->g - colour.g, entry->b - colour.b, entry->index));
  return static_cast<std::uint8_t>(best);
}

NearestSearch::Range NearestSearch::listed(Rgb8 colour, std::size_t level) {
  Range& range = levels_[level].around(colour);
  if (range.count == 0)
    range = list(colour, levels_[level].shift, level == 0 ? all_ : listed(colour, level - 1));
  return range;
}

NearestSearch::Range NearestSearch::list(Rgb8 colour, int shift, Range from) {
  const int last = (1 << shift) - 1;
  // Twice the lengths keep the centre's halves whole.
  const auto twice_centre = [&](int inside) { return 2 * (inside & ~last) + last; };
  const int r = twice_centre(colour.r), g = twice_centre(colour.g), b = twice_centre(colour.b);
  candidates_.resize(candidates_.size() + from.count);  // room for all, until it is known for whom
  const Candidate* const entries = candidates_.data() + from.first;
  std::array<int, kLutEntries> distance;  // from the centre
  for (std::size_t i = 0; i < from.count; ++i)
    distance[i] =
        square(2 * entries[i].r - r) + square(2 * entries[i].g - g) + square(2 * entries[i].b - b);
  const auto least = std::min_element(distance.begin(), distance.begin() + from.count);
  const Candidate nearest = entries[least - distance.begin()];
  const int limit = *least;
  Range range{static_cast<std::uint32_t>(candidates_.size()) - from.count, 0};
  for (std::size_t i = 0; i < from.count; ++i) {
    const Candidate entry = entries[i];
    // At the corner that favours the entry most; there as near as the nearest is near enough.
    const int gain = 4 * last *
                     (std::abs(entry.r - nearest.r) + std::abs(entry.g - nearest.g) +
                      std::abs(entry.b - nearest.b));
    candidates_[range.first + range.count] = entry;
    range.count += distance[i] <= limit + gain;
  }
  candidates_.resize(range.first + range.count);
  return range;
}

}  // namespace sir::quant
