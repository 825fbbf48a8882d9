#include "viewer/sixel.h"

#include <gmock/gmock.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <regex>
#include <stdexcept>
#include <string>

#include "eltek/dac.h"
#include "quant/lattice.h"

namespace sir::viewer {
namespace {

using eltek::IndexedScreen;
using testing::HasSubstr;
using testing::Not;

IndexedScreen screen(ImageSize size, std::vector<std::uint8_t> indices) {
  IndexedScreen made{size, std::move(indices), {}, {}};
  for (std::size_t i = 0; i < 256; ++i)
    made.palette[i] = eltek::dac_colour({static_cast<std::uint8_t>(i % 64),
                                         static_cast<std::uint8_t>(63 - i % 64),
                                         static_cast<std::uint8_t>(i / 4)});
  return made;
}

// By hand: a sixel is 63 + the bits of its pixels, the upper one 1.
TEST(Sixel, IsWhatTheFormatSays) {
  EXPECT_EQ(sixel(screen({2, 2}, {0, 63, 63, 63})),
            "\x1bPq\"1;1;2;2#0;2;0;100;0#63;2;100;0;24#0@$#63AB\x1b\\");
}

TEST(Sixel, RunsAndBands) {
  IndexedScreen made = screen({300, 7}, std::vector<std::uint8_t>(2100, 5));
  made.indices[150] = 9;
  made.indices[1800] = 255;  // row 6, column 0
  EXPECT_EQ(sixel(made),
            "\x1bPq\"1;1;300;7#5;2;8;92;2#9;2;14;86;3#255;2;100;0;100"
            "#5!150~}!149~$#9!150?@-#255@#5!299@\x1b\\");
}

TEST(Sixel, EqualColoursKeepTheirRegisters) {
  IndexedScreen made = screen({2, 1}, {7, 200});
  made.palette[200] = made.palette[7];
  const std::string text = sixel(made);
  EXPECT_THAT(text, HasSubstr("#7;2;11;89;2#200;2;11;89;2"));
  EXPECT_THAT(text, Not(HasSubstr("#8")));  // no pixel has it
}

/// The percents of the registers' definitions.
std::vector<std::array<int, 3>> percents(const std::string& text) {
  std::vector<std::array<int, 3>> all;
  static const std::regex kDefinition("#[0-9]+;2;([0-9]+);([0-9]+);([0-9]+)");
  for (std::sregex_iterator at(text.begin(), text.end(), kDefinition), end; at != end; ++at)
    all.push_back({std::stoi((*at)[1]), std::stoi((*at)[2]), std::stoi((*at)[3])});
  return all;
}

// As terminals make colours of percents: bytes rounded or cut off, or 16 bits of which the upper
// eight count.
TEST(Sixel, EveryCodeSurvivesEveryTerminalsRounding) {
  std::vector<std::uint8_t> indices(64);
  std::iota(indices.begin(), indices.end(), std::uint8_t{0});
  const auto all = percents(sixel(screen({8, 8}, indices)));
  ASSERT_EQ(all.size(), 64u);
  const quant::Lattice lattice({});
  for (int code = 0; code < 64; ++code) {
    const int percent = all[static_cast<std::size_t>(code)][0];
    for (const int byte :
         {(percent * 255 + 50) / 100, percent * 255 / 100, (percent * 65535 / 100) >> 8}) {
      const auto seen = static_cast<std::uint8_t>(byte);
      EXPECT_EQ(lattice.nearest({seen, 0, 0})[0], code) << byte;
      EXPECT_NEAR(byte, eltek::dac_level(static_cast<std::uint8_t>(code)), 2) << code;
    }
  }
}

TEST(Sixel, ADacOfEightBitsGetsTheNearestPercents) {
  IndexedScreen made = screen({1, 1}, {4});
  made.dac = {{8, 8, 8}};
  made.palette[4] = {1, 127, 254};
  EXPECT_THAT(sixel(made), HasSubstr("#4;2;0;50;100#4@"));
}

TEST(Sixel, NoByteIsMissedByMoreThan2) {
  std::vector<std::uint8_t> indices(256);
  std::iota(indices.begin(), indices.end(), std::uint8_t{0});
  IndexedScreen made = screen({16, 16}, indices);
  made.dac = {{8, 8, 8}};
  for (const std::uint8_t i : indices) made.palette[i] = {i, i, i};
  const auto all = percents(sixel(made));
  ASSERT_EQ(all.size(), 256u);
  for (int byte = 0; byte < 256; ++byte) {
    const int percent = all[static_cast<std::size_t>(byte)][2];
    EXPECT_NEAR((percent * 255 + 50) / 100, byte, 2);
    EXPECT_NEAR(percent * 255 / 100, byte, 2);
  }
}

TEST(Sixel, RefusesAScreenWithoutPixels) {
  EXPECT_THROW(sixel({}), std::invalid_argument);
  EXPECT_THROW(sixel(screen({0, 5}, {})), std::invalid_argument);
  EXPECT_THROW(sixel(screen({5, 5}, {1})), std::invalid_argument);
}

}  // namespace
}  // namespace sir::viewer
