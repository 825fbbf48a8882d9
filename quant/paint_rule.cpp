#include "quant/paint_rule.h"

#include <algorithm>
#include <array>

#include "quant/color_space.h"
#include "tracer/text_file.h"

namespace sir::quant {
namespace {

constexpr std::int64_t kCircle = 360 * kBillion;

/// Digits, at most nine of them after a point; no sign, no exponent.
bool parse_decimal(std::string_view text, std::int64_t most, std::int64_t& billionths) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  const std::string_view places = point < text.size() ? text.substr(point + 1) : "";
  if (whole.size() + places.size() == 0 || whole.size() > 9 || places.size() > 9) return false;
  std::int64_t value = 0;
  const auto append = [&value](char digit) {
    value = 10 * value + (digit - '0');
    return digit >= '0' && digit <= '9';
  };
  if (!std::all_of(whole.begin(), whole.end(), append)) return false;
  if (!std::all_of(places.begin(), places.end(), append)) return false;
  for (std::size_t place = places.size(); place < 9; ++place) value *= 10;
  if (value > most) return false;
  billionths = value;
  return true;
}

bool parse_range(std::string_view text, std::int64_t most, bool wraps,
                 std::optional<DecimalRange>& range) {
  DecimalRange read{0, most};
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) {
    if (!parse_decimal(text, most, read.low)) return false;
    read.high = read.low;
  } else {
    const std::string_view low = text.substr(0, dots), high = text.substr(dots + 2);
    if (!low.empty() && !parse_decimal(low, most, read.low)) return false;
    if (!high.empty() && !parse_decimal(high, most, read.high)) return false;
  }
  if (!wraps && read.low > read.high) return false;
  range = read;
  return true;
}

bool parse_bytes(std::string_view text, Rgb8& colour) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(',') : text.size();
    std::int64_t byte = 0;
    if (end == std::string_view::npos || !parse_count(text.substr(0, end), byte) || byte > 255)
      return false;
    bytes[i] = static_cast<std::uint8_t>(byte);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  colour = {bytes[0], bytes[1], bytes[2]};
  return true;
}

/// Whether numerator / denominator, in units, lies within the range.
bool within(const DecimalRange& range, std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t x = numerator * kBillion;
  const bool above = x >= range.low * denominator, below = x <= range.high * denominator;
  return range.low <= range.high ? above && below : above || below;
}

}  // namespace

bool parse_unit_range(std::string_view text, std::optional<DecimalRange>& range) {
  return parse_range(text, kBillion, false, range);
}

bool parse_hue_range(std::string_view text, std::optional<DecimalRange>& range) {
  return parse_range(text, kCircle, true, range);
}

bool parse_brush(std::string_view text, Brush& brush) {
  Brush read;
  constexpr std::string_view kHue = "hue:";
  if (text.starts_with(kHue)) {
    read.kind = Brush::Kind::hue;
    if (!parse_decimal(text.substr(kHue.size()), kCircle, read.hue)) return false;
  } else if (text != "keep") {
    read.kind = Brush::Kind::colour;
    if (!parse_bytes(text, read.colour)) return false;
  }
  brush = read;
  return true;
}

bool parse_rule(std::string_view text, PaintRule& rule) {
  PaintRule read;
  bool has_brush = false;
  for (const std::string_view word : split_tokens(text)) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string_view key = word.substr(0, equals);
    const std::string_view value = word.substr(std::min(equals + 1, word.size()));
    bool right = false;
    if (key == "h") right = !read.hue && parse_hue_range(value, read.hue);
    if (key == "s") right = !read.saturation && parse_unit_range(value, read.saturation);
    if (key == "v") right = !read.value && parse_unit_range(value, read.value);
    if (key == "with") right = !has_brush && (has_brush = parse_brush(value, read.with));
    if (!right) return false;
  }
  if (!has_brush || (!read.hue && !read.saturation && !read.value)) return false;
  rule = read;
  return true;
}

bool picks(const PaintRule& rule, Rgb8 colour) {
  const auto [max, chroma, sixth] = hexagon_of(colour);
  if (rule.value && !within(*rule.value, max, 255)) return false;
  // Black has saturation 0, not 0/0.
  if (rule.saturation && !within(*rule.saturation, chroma, std::max(max, 1))) return false;
  if (!rule.hue) return true;
  if (chroma == 0) return false;
  return within(*rule.hue, std::int64_t{60} * sixth, chroma) ||
         (sixth == 0 && within(*rule.hue, 360, 1));
}

}  // namespace sir::quant
