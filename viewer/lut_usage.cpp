#include "viewer/lut_usage.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "quant/ciede2000.h"
#include "quant/color_space.h"

namespace sir::viewer {
namespace {

/// Sorts the indices by a key of each; std::stable_sort keeps the LUT's order among equals.
template <typename Key>
void sort_by(std::array<std::uint8_t, quant::kLutEntries>& order, const Key& key) {
  std::array<decltype(key(0)), quant::kLutEntries> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = key(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return keys[a] < keys[b]; });
}

}  // namespace

LutUsage lut_usage(const quant::Lut& lut, std::span<const std::uint8_t> indices) {
  LutUsage usage;
  for (const std::uint8_t index : indices) ++usage.pixels[index];
  usage.unused = static_cast<std::size_t>(std::count(usage.pixels.begin(), usage.pixels.end(), 0u));
  for (std::size_t i = 0; i < quant::kLutEntries; ++i)
    for (std::size_t earlier = 0; earlier < i; ++earlier)
      if (lut.seen(earlier) == lut.seen(i)) {
        ++usage.repeated;
        break;
      }
  return usage;
}

std::array<std::uint8_t, quant::kLutEntries> entry_order(const quant::Lut& lut,
                                                         const LutUsage& usage, EntryOrder order) {
  std::array<std::uint8_t, quant::kLutEntries> indices;
  std::iota(indices.begin(), indices.end(), std::uint8_t{0});
  switch (order) {
    case EntryOrder::index: break;
    case EntryOrder::pixels:
      sort_by(indices, [&](std::size_t i) { return ~usage.pixels[i]; });
      break;
    case EntryOrder::hue:
      sort_by(indices, [&](std::size_t i) {
        const quant::Hsv hsv = quant::hsv_of(lut.seen(i));
        return std::tuple(hsv.s > 0, hsv.h, hsv.v);
      });
      break;
    case EntryOrder::lightness:
      sort_by(indices, [&](std::size_t i) { return quant::lab_of(lut.seen(i)).l; });
      break;
  }
  return indices;
}

PrimaryHistogram primary_histogram(const Planes& picture, std::size_t bins) {
  if (bins == 0 || 256 % bins != 0) throw std::invalid_argument("bins that do not divide 256");
  PrimaryHistogram histogram;
  for (std::size_t c = 0; c < 3; ++c) {
    histogram[c].resize(bins);
    for (const std::uint8_t byte : picture.channel[c]) ++histogram[c][byte * bins / 256];
  }
  return histogram;
}

}  // namespace sir::viewer
