#include "quant/nearest.h"

#include <algorithm>
#include <cstdlib>

namespace sir::quant {
namespace {

constexpr int square(int x) { return x * x; }

using Colours = std::array<Rgb8, kLutEntries>;

Colours colours_of(const Lut& lut) {
  Colours colours;
  std::transform(lut.entry.begin(), lut.entry.end(), colours.begin(), seen);
  return colours;
}

std::uint8_t nearest_of(Rgb8 colour, const Colours& entries) {
  std::size_t best = 0;
  int best_distance = 3 * square(255) + 1;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    const Rgb8 entry = entries[i];
    const int distance =
        square(entry.r - colour.r) + square(entry.g - colour.g) + square(entry.b - colour.b);
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  return static_cast<std::uint8_t>(best);
}

/// Distance and index in one number, so that the least of them is the nearest
/// entry, the lowest index among equals. Distances are below 2^18.
constexpr std::uint32_t ranked(int r, int g, int b, std::uint8_t index) {
  return static_cast<std::uint32_t>(square(r) + square(g) + square(b)) << 8 | index;
}

/// Answers already given, one for each hash of the colour. Renders and
/// drawings repeat their colours, so most pixels end here.
class Memory {
 public:
  Memory() : slots_(std::size_t{1} << kBits) {}

  struct Slot {
    std::uint32_t colour = kNone;
    std::uint8_t index = 0;
  };
  Slot& slot(std::uint32_t colour) { return slots_[colour * 0x9E3779B1u >> (32 - kBits)]; }

 private:
  static constexpr int kBits = 14;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;  // no colour of 24 bits
  std::vector<Slot> slots_;
};

}  // namespace

std::uint8_t nearest_entry(Rgb8 colour, const Lut& lut) {
  return nearest_of(colour, colours_of(lut));
}

std::vector<std::uint8_t> map_exhaustively(const Planes& image, const Lut& lut) {
  const Colours colours = colours_of(lut);
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = nearest_of(image.at(i), colours);
  return indices;
}

std::vector<std::uint8_t> map_to_lut(const Planes& image, const Lut& lut) {
  std::vector<std::uint8_t> indices(image.size.pixels());
  NearestSearch search(lut);
  Memory memory;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Rgb8 colour = image.at(i);
    const std::uint32_t key =
        std::uint32_t{colour.r} << 16 | std::uint32_t{colour.g} << 8 | colour.b;
    Memory::Slot& slot = memory.slot(key);
    if (slot.colour != key) slot = {key, search(colour)};
    indices[i] = slot.index;
  }
  return indices;
}

NearestSearch::NearestSearch(const Lut& lut) {
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (std::find(lut.entry.begin(), lut.entry.begin() + static_cast<std::ptrdiff_t>(i),
                  lut.entry[i]) != lut.entry.begin() + static_cast<std::ptrdiff_t>(i))
      continue;  // an equal entry of lower index always comes first
    const Rgb8 bytes = seen(lut.entry[i]);
    entries_.push_back({bytes.r, bytes.g, bytes.b, static_cast<std::uint8_t>(i)});
  }
}

std::uint8_t NearestSearch::operator()(Rgb8 colour) {
  Range& range = cubes_[static_cast<std::size_t>(
      ((colour.r >> kShift) * kSide + (colour.g >> kShift)) * kSide + (colour.b >> kShift))];
  if (range.count == 0) list_candidates(colour, range);
  std::uint32_t best = 0xFFFFFFFF;
  const Candidate* const first = candidates_.data() + range.first;
  for (const Candidate* entry = first; entry != first + range.count; ++entry)
    best = std::min(
        best, ranked(entry->r - colour.r, entry->g - colour.g, entry->b - colour.b, entry->index));
  return static_cast<std::uint8_t>(best);
}

void NearestSearch::list_candidates(Rgb8 colour, Range& range) {
  constexpr int kLast = (1 << kShift) - 1;
  // Twice the distances from the cube's middle keep the halves whole.
  const auto twice_from_middle = [](int level, int inside) {
    return std::abs(2 * level - 2 * (inside & ~kLast) - kLast);
  };
  const auto least = [](int twice) { return square(std::max(twice - kLast, 0)); };
  const auto greatest = [](int twice) { return square(twice + kLast); };

  std::vector<int> nearest_to_cube;
  int limit = 4 * 3 * square(255);
  for (const Candidate& entry : entries_) {
    const int r = twice_from_middle(entry.r, colour.r);
    const int g = twice_from_middle(entry.g, colour.g);
    const int b = twice_from_middle(entry.b, colour.b);
    nearest_to_cube.push_back(least(r) + least(g) + least(b));
    limit = std::min(limit, greatest(r) + greatest(g) + greatest(b));
  }
  range.first = static_cast<std::uint32_t>(candidates_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (nearest_to_cube[i] <= limit) candidates_.push_back(entries_[i]);
  range.count = static_cast<std::uint32_t>(candidates_.size()) - range.first;
}

}  // namespace sir::quant
