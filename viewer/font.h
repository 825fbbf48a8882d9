// The letters in which the viewer speaks, drawn for it: five by seven points in cells of six by
// eight. The thesis has none; its monitor showed pictures only.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace sir::viewer {

inline constexpr int kLetterWidth = 6;   ///< from one letter to the next, the gap of one included
inline constexpr int kLetterHeight = 8;  ///< the last row is for descenders
inline constexpr int kLinePitch = 10;    ///< from one line of a text to the next

/// A letter's rows from the top; bit 4 is the leftmost of its five points, bit 0 the rightmost.
using Glyph = std::array<std::uint8_t, kLetterHeight>;

/// The glyph of a Unicode character: ASCII 32 to 126, Latin-1 160 to 255, and the others() below.
/// Any other has an upright box.
const Glyph& glyph(char32_t character);

/// Whether glyph() is the character's own, and not the box.
bool has_glyph(char32_t character);

/// The characters beyond Latin-1 that have glyphs: arrows, dashes, quotation marks, some of
/// mathematics and some shapes.
std::u32string_view others();

/// Takes the next character off a UTF-8 text that is not empty. A byte that belongs to no
/// character comes as U+FFFD, which has the box.
char32_t take_character(std::string_view& text);

/// What a line of UTF-8 text takes, in pixels: kLetterWidth for each character, times the scale.
int text_width(std::string_view text, int scale = 1);

/// The text, or as much of its beginning as fits the width with "…" behind it; empty where not
/// even that fits.
std::string fitted(std::string_view text, int width, int scale = 1);

}  // namespace sir::viewer
