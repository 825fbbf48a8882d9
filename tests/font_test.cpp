// The viewer's letters: all that is promised is there, told apart, and read from UTF-8.
#include "viewer/font.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace sir::viewer {
namespace {

constexpr char32_t kUnknown = 0xFFFD;

/// A glyph as a person would draw it.
std::string drawn(const Glyph& rows) {
  std::string text;
  for (const std::uint8_t row : rows) {
    for (int point = 4; point >= 0; --point) text += (row >> point & 1) != 0 ? '#' : '.';
    text += '\n';
  }
  return text;
}

/// All characters that have glyphs.
std::u32string all() {
  std::u32string characters;
  for (char32_t c = 32; c <= 126; ++c) characters += c;
  for (char32_t c = 160; c <= 255; ++c) characters += c;
  return characters.append(others());
}

TEST(Font, ALetterIsAsItIsDrawn) {
  EXPECT_EQ(drawn(glyph(U'R')), "####.\n#...#\n#...#\n####.\n#.#..\n#..#.\n#...#\n.....\n");
  EXPECT_EQ(drawn(glyph(U'g')), ".....\n.....\n.####\n#...#\n#...#\n.####\n....#\n.###.\n");
  EXPECT_EQ(drawn(glyph(0xE3)), ".##.#\n#.##.\n.....\n.####\n#...#\n#..##\n.##.#\n.....\n");
  EXPECT_EQ(drawn(glyph(0x2192)), ".....\n..#..\n...#.\n#####\n...#.\n..#..\n.....\n.....\n");
}

TEST(Font, HasAllThatIsPromisedAndABoxForTheRest) {
  const Glyph box = glyph(kUnknown);
  EXPECT_EQ(drawn(box), "#####\n#...#\n#...#\n#...#\n#...#\n#...#\n#####\n.....\n");
  EXPECT_FALSE(has_glyph(kUnknown));
  for (const char32_t c : all()) {
    EXPECT_TRUE(has_glyph(c)) << static_cast<unsigned>(c);
    EXPECT_NE(glyph(c), box) << static_cast<unsigned>(c);
  }
  for (const char32_t c : {U'\0', U'\n', U'\x7F', U'\x80', U'\x9F', U'\u0100', U'\u4E00',
                           U'\U0001F600', char32_t{0xFFFFFFFF}})
    EXPECT_EQ(glyph(c), box) << static_cast<unsigned>(c);
}

TEST(Font, NoTwoLettersLookTheSame) {
  // The two spaces, the hyphens and the minus are meant to.
  const std::u32string alike = U"\u00A0\u2212\u2013\u2014\u2019\u2018\u00AD";
  std::map<Glyph, char32_t> seen;
  for (const char32_t c : all()) {
    if (alike.find(c) != std::u32string::npos) continue;
    const auto [other, fresh] = seen.emplace(glyph(c), c);
    EXPECT_TRUE(fresh) << static_cast<unsigned>(c) << " looks like "
                       << static_cast<unsigned>(other->second) << "\n"
                       << drawn(glyph(c));
  }
}

TEST(Font, TakesCharactersOffUtf8) {
  std::string_view text = "aç→\U0001F600";
  EXPECT_EQ(take_character(text), U'a');
  EXPECT_EQ(take_character(text), U'\u00E7');
  EXPECT_EQ(take_character(text), U'\u2192');
  EXPECT_EQ(take_character(text), U'\U0001F600');
  EXPECT_TRUE(text.empty());
}

TEST(Font, ABadByteIsOneUnknownCharacter) {
  // A tail alone, a head alone, a cut character, too long a form, a surrogate, past the end.
  const std::map<std::string, std::size_t> bad{
      {"\x80", 1},         {"\xC3", 1},         {"\xE2\x86", 2},         {"\xC0\xAF", 2},
      {"\xE0\x80\xAF", 3}, {"\xED\xA0\x80", 3}, {"\xF4\x90\x80\x80", 4}, {"\xFF", 1}};
  for (const auto& [bytes, count] : bad) {
    const std::string whole = bytes + "x";
    std::string_view text = whole;
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(take_character(text), kUnknown) << bytes;
    EXPECT_EQ(take_character(text), U'x');
    EXPECT_TRUE(text.empty());
  }
}

TEST(Font, WidthCountsCharactersNotBytes) {
  EXPECT_EQ(text_width(""), 0);
  EXPECT_EQ(text_width("abc"), 3 * kLetterWidth);
  EXPECT_EQ(text_width("não", 2), 2 * 3 * kLetterWidth);
}

TEST(Font, FittedCutsAndSaysSo) {
  EXPECT_EQ(fitted("piramide", 8 * kLetterWidth), "piramide");
  EXPECT_EQ(fitted("piramide", 8 * kLetterWidth - 1), "pirami…");
  EXPECT_EQ(fitted("pirâmide", 5 * kLetterWidth), "pirâ…");
  EXPECT_EQ(fitted("piramide", 2 * kLetterWidth, 2), "…");
  EXPECT_EQ(fitted("piramide", kLetterWidth - 1), "");
  EXPECT_EQ(fitted("", 0), "");
}

}  // namespace
}  // namespace sir::viewer
