#include "quant/paint.h"

#include <algorithm>

#include "quant/color_space.h"

namespace sir::quant {
namespace {

Rgb8 luma_of(Rgb8 colour) {
  const auto luma =
      static_cast<std::uint8_t>((299 * colour.r + 587 * colour.g + 114 * colour.b + 500) / 1000);
  return {luma, luma, luma};
}

Rgb8 turned(std::int64_t hue, Rgb8 colour) {
  constexpr std::int64_t kSixth = 60 * kBillion;
  const auto hexagon = hexagon_of(colour);
  const std::int64_t max = hexagon.max, chroma = hexagon.chroma, along = hue % kSixth;
  const auto byte = [](std::int64_t sixths) {
    return static_cast<std::uint8_t>((2 * sixths + kSixth) / (2 * kSixth));
  };
  const std::uint8_t v = byte(max * kSixth), p = byte((max - chroma) * kSixth);
  const std::uint8_t t = byte((max - chroma) * kSixth + chroma * along);
  const std::uint8_t q = byte(max * kSixth - chroma * along);
  switch (hue / kSixth) {
    case 1: return {q, v, p};
    case 2: return {p, v, t};
    case 3: return {p, q, v};
    case 4: return {t, p, v};
    case 5: return {v, p, q};
    default: return {v, t, p};  // 0, and 360 degrees
  }
}

}  // namespace

Rgb8 brushed(const Brush& brush, Rgb8 colour) {
  switch (brush.kind) {
    case Brush::Kind::colour: return brush.colour;
    case Brush::Kind::hue: return turned(brush.hue, colour);
    default: return colour;
  }
}

Painted paint(const Planes& image, std::span<const PaintRule> rules, Rest rest) {
  Painted result{image, std::vector<std::uint64_t>(rules.size())};
  for (std::size_t pixel = 0; pixel < image.size.pixels(); ++pixel) {
    const Rgb8 colour = image.at(pixel);
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&](const PaintRule& each) { return picks(each, colour); });
    if (rule != rules.end()) {
      ++result.picked[static_cast<std::size_t>(rule - rules.begin())];
      result.image.set(pixel, brushed(rule->with, colour));
    } else if (rest == Rest::grey) {
      result.image.set(pixel, luma_of(colour));
    }
  }
  return result;
}

}  // namespace sir::quant
