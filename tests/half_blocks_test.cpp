#include "viewer/half_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace sir::viewer {
namespace {

eltek::Screen noise(ImageSize size, unsigned seed) {
  std::mt19937 random(seed);
  eltek::Screen screen{size, {}};
  const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
  // Equal neighbours now and then: they are not set again.
  for (std::size_t i = 0; i < size.pixels(); ++i)
    screen.pixels.push_back(i > 0 && random() % 3 == 0 ? screen.pixels.back()
                                                       : Rgb8{byte(), byte(), byte()});
  return screen;
}

/// A terminal's idea of the text: the pixels, two rows a line; a row without background ends it.
struct Terminal {
  std::vector<std::vector<Rgb8>> rows;
  bool good = true;

  explicit Terminal(const std::string& text) {
    Rgb8 fore, back;
    bool has_back = false, has_fore = false;
    std::size_t line = 0;
    for (std::size_t i = 0; i < text.size();) {
      if (text.compare(i, 2, "\x1b[") == 0) {
        const auto end = text.find('m', i);
        std::istringstream numbers(text.substr(i + 2, end - i - 2));
        for (int what = 0; numbers >> what; numbers.ignore(1)) {
          if (what == 0) {
            has_fore = has_back = false;
            continue;
          }
          int two = 0, r = 0, g = 0, b = 0;
          char c = 0;
          numbers >> c >> two >> c >> r >> c >> g >> c >> b;
          good = good && two == 2 && (what == 38 || what == 48);
          const Rgb8 colour{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                            static_cast<std::uint8_t>(b)};
          (what == 38 ? fore : back) = colour;
          (what == 38 ? has_fore : has_back) = true;
        }
        i = end + 1;
      } else if (text.compare(i, 3, "\u2580") == 0) {
        rows.resize(2 * line + 2);
        good = good && has_fore;
        rows[2 * line].push_back(fore);
        if (has_back) rows[2 * line + 1].push_back(back);
        i += 3;
      } else {
        good = good && text[i] == '\n' && !has_fore && !has_back;  // reset before the end
        ++line;
        ++i;
      }
    }
  }
};

TEST(HalfBlocks, OnePixelByHand) {
  EXPECT_EQ(half_blocks({{1, 2}, {{1, 2, 3}, {40, 50, 60}}}, 80),
            "\x1b[38;2;1;2;3;48;2;40;50;60m\u2580\x1b[0m\n");
}

TEST(HalfBlocks, WhatFitsIsShownPixelForPixel) {
  for (const ImageSize size : {ImageSize{80, 48}, {1, 1}, {37, 11}, {3, 2}}) {
    const eltek::Screen screen = noise(size, 5);
    const Terminal shown(half_blocks(screen, 80));
    EXPECT_TRUE(shown.good);
    ASSERT_EQ(shown.rows.size(), static_cast<std::size_t>(size.height + size.height % 2));
    for (int row = 0; row < size.height; ++row) {
      const auto& line = shown.rows[static_cast<std::size_t>(row)];
      ASSERT_EQ(line.size(), static_cast<std::size_t>(size.width));
      for (int column = 0; column < size.width; ++column)
        ASSERT_EQ(line[static_cast<std::size_t>(column)], screen.at(column, row));
    }
    if (size.height % 2 == 1) {
      EXPECT_TRUE(shown.rows.back().empty());
    }
  }
}

TEST(HalfBlocks, AWholeFactorFitsTheColumns) {
  EXPECT_EQ(half_block_factor(1024, 80), 13);
  EXPECT_EQ(half_block_factor(1024, 1024), 1);
  EXPECT_EQ(half_block_factor(1024, 1023), 2);
  EXPECT_EQ(half_block_factor(5, 80), 1);
  const Terminal shown(half_blocks(noise({1024, 780}, 1), 80));
  EXPECT_TRUE(shown.good);
  ASSERT_EQ(shown.rows.size(), 60u);  // 780 / 13
  for (const auto& row : shown.rows) EXPECT_EQ(row.size(), 79u);
}

double light_of(std::uint8_t byte) {
  const double coded = byte / 255.0;
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

double coded_of(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

TEST(HalfBlocks, APixelIsTheMeanOfItsLight) {
  const eltek::Screen screen = noise({50, 31}, 9);  // cut off at the right and below
  constexpr int kFactor = 4;
  const Terminal shown(half_blocks(screen, 13));
  ASSERT_EQ(shown.rows.size(), 8u);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 13; ++column) {
      double sum = 0;
      int pixels = 0;
      for (int y = kFactor * row; y < std::min(kFactor * row + kFactor, 31); ++y)
        for (int x = kFactor * column; x < std::min(kFactor * column + kFactor, 50); ++x) {
          sum += light_of(screen.at(x, y).g);
          ++pixels;
        }
      const Rgb8 got = shown.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      EXPECT_NEAR(255 * coded_of(sum / pixels), got.g, 0.5 + 1e-9);
    }
}

// The mean of a black and a white byte is 128; that of their light is seen as 188.
TEST(HalfBlocks, BlackAndWhiteMixTo188) {
  EXPECT_EQ(half_blocks({{2, 1}, {{0, 0, 0}, {255, 255, 255}}}, 1),
            "\x1b[38;2;188;188;188m\u2580\x1b[0m\n");
}

TEST(HalfBlocks, RefuseNothingToShow) {
  EXPECT_THROW(half_blocks({}, 80), std::invalid_argument);
  EXPECT_THROW(half_blocks({{1, 1}, {{}}}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sir::viewer
