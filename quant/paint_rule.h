// Which colours are picked by hue, saturation and value, and how they are shown
// (thesis 3.4.3: bringing out areas of interest).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tracer/planes.h"

namespace sir::quant {

/// Limits are whole numbers of billionths, so that a decimal of up to nine
/// places is exactly what was written.
inline constexpr std::int64_t kBillion = 1'000'000'000;

/// Both ends belong to the range.
struct DecimalRange {
  std::int64_t low = 0, high = 0;  ///< billionths of a degree, or of full saturation or value
  friend bool operator==(const DecimalRange&, const DecimalRange&) = default;
};

/// How a picked pixel is shown.
struct Brush {
  enum class Kind {
    keep,    ///< as it is
    colour,  ///< as `colour`
    hue      ///< in another hue, saturation and value kept; greys stay
  };
  Kind kind = Kind::keep;
  Rgb8 colour{};
  std::int64_t hue = 0;  ///< billionths of a degree, 0 to 360 degrees
  friend bool operator==(const Brush&, const Brush&) = default;
};

/// Colours within all of the ranges that are given are picked.
struct PaintRule {
  /// Wraps where low > high: 350..20 holds red. 0 degrees are also 360. A grey
  /// (r = g = b) has no hue: a rule with a range of hues never picks it.
  std::optional<DecimalRange> hue;
  std::optional<DecimalRange> saturation, value;  ///< 0 to 1
  Brush with;
};

/// The parsers return false, and leave the value alone, where the text is
/// nothing of the kind. Numbers are plain decimals of up to nine places.

/// "LOW..HIGH", "LOW..", "..HIGH" or one number alone; from 0 to 1, low <= high.
bool parse_unit_range(std::string_view text, std::optional<DecimalRange>& range);

/// The same in degrees from 0 to 360; low > high wraps.
bool parse_hue_range(std::string_view text, std::optional<DecimalRange>& range);

/// "R,G,B" (bytes), "hue:DEGREES" or "keep".
bool parse_brush(std::string_view text, Brush& brush);

/// Words with white space between them, each at most once, in any order:
/// h=RANGE s=RANGE v=RANGE with=BRUSH. At least one range, and the brush.
bool parse_rule(std::string_view text, PaintRule& rule);

/// Whether the rule picks the colour: its true hue, saturation and value (see
/// HexagonOfBytes) are compared with the limits in integers, without rounding.
bool picks(const PaintRule& rule, Rgb8 colour);

}  // namespace sir::quant
