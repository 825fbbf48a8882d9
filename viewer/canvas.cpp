#include "viewer/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "viewer/font.h"

namespace sir::viewer {
namespace {

constexpr std::uint32_t kOpaque = 255;

/// over / 255, rounded.
constexpr std::uint32_t by_255(std::uint32_t over) { return (over + kOpaque / 2) / kOpaque; }

constexpr std::uint32_t part(Argb colour, int shift) { return colour >> shift & 0xFF; }

/// A colour over a ground (Porter and Duff 1984). The viewer's ground is opaque; of another one the
/// colours are taken as they are and its alpha is carried on.
Argb over(Argb colour, Argb ground) {
  const std::uint32_t alpha = part(colour, 24), rest = kOpaque - alpha;
  Argb mixed = (alpha + by_255(part(ground, 24) * rest)) << 24;
  for (const int shift : {16, 8, 0})
    mixed |= by_255(part(colour, shift) * alpha + part(ground, shift) * rest) << shift;
  return mixed;
}

__extension__ typedef __int128 Wide;

/// floor(a / b) for b > 0.
std::int64_t floored(Wide a, std::int64_t b) {
  return static_cast<std::int64_t>(a / b - (a % b < 0));
}

}  // namespace

Argb legible_on(Rgb8 ground) {
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double luminance =
      0.2126 * linear(ground.r) + 0.7152 * linear(ground.g) + 0.0722 * linear(ground.b);
  // White's contrast is 1.05 / (l + 0.05), black's (l + 0.05) / 0.05.
  const bool dark = (luminance + 0.05) * (luminance + 0.05) < 1.05 * 0.05;
  return dark ? argb({255, 255, 255}) : argb({0, 0, 0});
}

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
  const auto shared = [](int a0, int a_length, int b0, int b_length, int& first, int& length) {
    const std::int64_t low = std::max(a0, b0);
    const std::int64_t high = std::min(std::int64_t{a0} + std::max(a_length, 0),
                                       std::int64_t{b0} + std::max(b_length, 0));
    first = static_cast<int>(low);
    length = static_cast<int>(std::max(high - low, std::int64_t{0}));
  };
  Rectangle both;
  shared(a.x, a.width, b.x, b.width, both.x, both.width);
  shared(a.y, a.height, b.y, b.height, both.y, both.height);
  return both;
}

Canvas::Canvas(std::span<Argb> pixels, ImageSize size, std::size_t pitch)
    : pixels_(pixels), size_(size), pitch_(pitch) {
  if (size.width < 0 || size.height < 0 || pitch < static_cast<std::size_t>(size.width) ||
      (size.height > 0 &&
       (static_cast<std::size_t>(size.height) - 1) * pitch + static_cast<std::size_t>(size.width) >
           pixels.size()))
    throw std::invalid_argument("a canvas larger than its pixels");
  clip_nothing();
}

Canvas::Canvas(std::span<Argb> pixels, ImageSize size)
    : Canvas(pixels, size, static_cast<std::size_t>(std::max(size.width, 0))) {}

void Canvas::set_clip(const Rectangle& clip) {
  clip_ = intersection(clip, {0, 0, size_.width, size_.height});
}

void Canvas::clip_nothing() { clip_ = {0, 0, size_.width, size_.height}; }

void Canvas::put(std::int64_t x, std::int64_t y, Argb colour) { fill_wide(x, y, 1, 1, colour); }

void Canvas::fill(const Rectangle& area, Argb colour) {
  fill_wide(area.x, area.y, area.width, area.height, colour);
}

void Canvas::fill_wide(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height,
                       Argb colour) {
  const auto left = static_cast<std::ptrdiff_t>(std::max<std::int64_t>(x, clip_.x));
  const auto right =
      static_cast<std::ptrdiff_t>(std::min(x + width, std::int64_t{clip_.x} + clip_.width));
  const std::int64_t top = std::max<std::int64_t>(y, clip_.y);
  const std::int64_t bottom = std::min(y + height, std::int64_t{clip_.y} + clip_.height);
  if (left >= right || top >= bottom) return;
  note_painted({static_cast<int>(left), static_cast<int>(top), static_cast<int>(right - left),
                static_cast<int>(bottom - top)});
  for (std::int64_t row = top; row < bottom; ++row) {
    const auto first = pixels_.begin() + static_cast<std::ptrdiff_t>(pitch_) * row;
    if (part(colour, 24) == kOpaque) {
      std::fill(first + left, first + right, colour);
      continue;
    }
    // Grounds are mostly even.
    Argb ground = first[left], mixed = over(colour, ground);
    std::for_each(first + left, first + right, [&](Argb& pixel) {
      if (pixel != ground) mixed = over(colour, ground = pixel);
      pixel = mixed;
    });
  }
}

void Canvas::note_painted(const Rectangle& area) {
  const bool first = right_ == 0;
  left_ = first ? area.x : std::min(left_, area.x);
  top_ = first ? area.y : std::min(top_, area.y);
  right_ = std::max(right_, area.x + area.width);
  bottom_ = std::max(bottom_, area.y + area.height);
}

Rectangle Canvas::painted() const { return {left_, top_, right_ - left_, bottom_ - top_}; }

void Canvas::frame(const Rectangle& area, Argb colour, int thickness) {
  if (thickness < 1 || area.width < 1 || area.height < 1) return;
  const std::int64_t x = area.x, y = area.y, width = area.width, height = area.height;
  const std::int64_t t = thickness;
  // Where the sides meet in the middle nothing is left within; no pixel is blended twice.
  if (2 * t >= width || 2 * t >= height) return fill(area, colour);
  fill_wide(x, y, width, t, colour);
  fill_wide(x, y + height - t, width, t, colour);
  fill_wide(x, y + t, t, height - 2 * t, colour);
  fill_wide(x + width - t, y + t, t, height - 2 * t, colour);
}

void Canvas::line(int x0, int y0, int x1, int y1, Argb colour) {
  const std::int64_t dx = std::int64_t{x1} - x0, dy = std::int64_t{y1} - y0;
  const bool flat = std::abs(dx) >= std::abs(dy);
  const std::int64_t steps = std::abs(flat ? dx : dy);
  if (steps == 0) return put(x0, y0, colour);
  // One pixel a step along the longer way, the nearest one across it; each by itself, so that
  // the steps beyond the clip can be left out and nothing moves.
  const std::int64_t start = flat ? x0 : y0, across = flat ? dy : dx;
  const bool forwards = (flat ? dx : dy) > 0;
  const std::int64_t low = flat ? clip_.x : clip_.y;
  const std::int64_t high = low + (flat ? clip_.width : clip_.height) - 1;
  const std::int64_t from = std::max<std::int64_t>(0, forwards ? low - start : start - high);
  const std::int64_t to = std::min(steps, forwards ? high - start : start - low);
  for (std::int64_t i = from; i <= to; ++i) {
    const std::int64_t along = start + (forwards ? i : -i);
    const std::int64_t moved = floored(Wide{across} * i + steps / 2, steps);
    if (flat) put(along, y0 + moved, colour);
    else put(x0 + moved, along, colour);
  }
}

int Canvas::text(int x, int y, std::string_view text, Argb colour, int scale) {
  std::int64_t at = x;
  for (; !text.empty(); at += std::int64_t{kLetterWidth} * scale) {
    const Glyph& rows = glyph(take_character(text));
    const bool seen = at < std::int64_t{clip_.x} + clip_.width &&
                      at + std::int64_t{kLetterWidth} * scale > clip_.x;
    if (!seen) continue;
    for (int row = 0; row < kLetterHeight; ++row)
      for (int point = 0; point < kLetterWidth - 1; ++point)
        if ((rows[static_cast<std::size_t>(row)] >> (kLetterWidth - 2 - point) & 1) != 0)
          fill_wide(at + std::int64_t{point} * scale, y + std::int64_t{row} * scale, scale, scale,
                    colour);
  }
  return static_cast<int>(at);
}

}  // namespace sir::viewer
