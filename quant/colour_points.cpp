#include "quant/colour_points.h"

#include <array>
#include <stdexcept>

namespace sir::quant {
namespace {

constexpr int kBits = 8;

// The bits of a byte, two places free between them.
constexpr std::array<std::uint32_t, 256> kSpread = [] {
  std::array<std::uint32_t, 256> spread{};
  for (std::uint32_t byte = 0; byte < 256; ++byte)
    for (int bit = 0; bit < kBits; ++bit) spread[byte] |= (byte >> bit & 1) << 3 * bit;
  return spread;
}();

std::uint32_t morton(Rgb8 colour) {
  return kSpread[colour.r] << 2 | kSpread[colour.g] << 1 | kSpread[colour.b];
}

std::uint8_t gathered(std::uint32_t bits) {
  std::uint32_t byte = 0;
  for (int bit = 0; bit < kBits; ++bit) byte |= (bits >> 3 * bit & 1) << bit;
  return static_cast<std::uint8_t>(byte);
}

Rgb8 colour_of(std::uint32_t code) {
  return {gathered(code >> 2), gathered(code >> 1), gathered(code)};
}

// Sorts by the upper 24 bits, a byte at a time.
void sort_by_colour(std::vector<std::uint32_t>& keys) {
  std::vector<std::uint32_t> other(keys.size());
  for (int shift = 8; shift < 32; shift += 8) {
    std::array<std::size_t, 257> start{};
    for (const std::uint32_t key : keys) ++start[(key >> shift & 255) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const std::uint32_t key : keys) other[start[key >> shift & 255]++] = key;
    keys.swap(other);
  }
}

}  // namespace

void WeightedColours::add(const Planes& image, std::span<const std::uint8_t> importance) {
  const std::size_t pixels = image.size.pixels();
  if (!importance.empty() && importance.size() != pixels)
    throw std::invalid_argument("an importance of another number of pixels than its image");
  std::vector<std::uint32_t> keys;
  keys.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t weight = importance.empty() ? 255 : importance[i];
    if (weight > 0) keys.push_back(morton(image.at(i)) << 8 | weight);
  }
  sort_by_colour(keys);

  std::vector<WeightedColour> merged;
  auto before = colours_.cbegin();
  for (std::size_t i = 0; i < keys.size();) {
    const std::uint32_t code = keys[i] >> 8;
    double weight = 0;
    for (; i < keys.size() && keys[i] >> 8 == code; ++i) weight += keys[i] & 255;
    while (before != colours_.cend() && morton(before->colour) < code) merged.push_back(*before++);
    merged.push_back({colour_of(code), weight / 255});
    if (before != colours_.cend() && morton(before->colour) == code)
      merged.back().weight += before++->weight;
  }
  merged.insert(merged.end(), before, colours_.cend());
  colours_ = std::move(merged);
}

ColourPoints WeightedColours::points(ColourMeasure& measure, std::size_t limit) const {
  std::vector<std::uint32_t> codes;
  codes.reserve(colours_.size());
  for (const WeightedColour& one : colours_) codes.push_back(morton(one.colour));
  const auto cubes = [&](int shift) {
    std::size_t count = codes.empty() ? 0 : 1;
    for (std::size_t i = 1; i < codes.size(); ++i)
      count += codes[i] >> shift != codes[i - 1] >> shift;
    return count;
  };
  int shift = 0;
  while (shift < 3 * kBits && cubes(shift) > limit) shift += 3;

  ColourPoints points;
  for (std::size_t first = 0, last = 0; first < colours_.size(); first = last) {
    while (last < colours_.size() && codes[last] >> shift == codes[first] >> shift) ++last;
    const std::span cube(colours_.data() + first, last - first);
    const ColourPoint& point = points.all.emplace_back(point_of(cube, measure));
    if (cube.size() > 1)
      for (const WeightedColour& one : cube)
        points.scatter +=
            one.weight * static_cast<double>(point.form(measure.point_of(one.colour) - point.at));
  }
  return points;
}

ColourPoint point_of(std::span<const WeightedColour> colours, ColourMeasure& measure) {
  ColourPoint point;
  if (colours.size() == 1) {
    const Rgb8 c = colours.front().colour;
    return {measure.point_of(c), measure.form_of(c), glm::vec3(c.r, c.g, c.b),
            static_cast<float>(colours.front().weight)};
  }
  for (const WeightedColour& one : colours) {
    const Rgb8 c = one.colour;
    const auto weight = static_cast<float>(one.weight);
    point.at += weight * measure.point_of(c);
    point.bytes += weight * glm::vec3(c.r, c.g, c.b);
    point.weight += weight;
  }
  point.at /= point.weight;
  point.bytes /= point.weight;
  const auto byte = [](float mean) { return static_cast<std::uint8_t>(mean + 0.5f); };
  point.form = measure.form_of({byte(point.bytes.x), byte(point.bytes.y), byte(point.bytes.z)});
  return point;
}

}  // namespace sir::quant
