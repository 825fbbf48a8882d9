// Painting: what lands where, and that the clip changes nothing within it.
#include "viewer/canvas.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "viewer/font.h"

namespace sir::viewer {
namespace {

constexpr Argb kBlack = 0xFF000000, kWhite = 0xFFFFFFFF, kRed = 0xFFFF0000;
constexpr int kFar = std::numeric_limits<int>::max();

/// A canvas with its pixels, black.
struct Sheet {
  std::vector<Argb> pixels;
  Canvas canvas;

  explicit Sheet(int width, int height)
      : pixels(static_cast<std::size_t>(width * height), kBlack), canvas(pixels, {width, height}) {}

  /// '.' for black, '#' for white, 'r' for red, '?' for any other.
  std::string drawn() const {
    std::string text;
    for (int y = 0; y < canvas.size().height; ++y, text += '\n')
      for (int x = 0; x < canvas.size().width; ++x) {
        const Argb pixel = canvas.at(x, y);
        text += pixel == kBlack ? '.' : pixel == kWhite ? '#' : pixel == kRed ? 'r' : '?';
      }
    return text;
  }
};

TEST(Canvas, RemembersWhereItWasPainted) {
  Sheet sheet(20, 10);
  EXPECT_EQ(sheet.canvas.painted(), Rectangle{});
  sheet.canvas.fill({-5, 30, 2, 2}, kRed);  // beyond
  sheet.canvas.fill({3, 3, 0, 4}, kRed);
  EXPECT_EQ(sheet.canvas.painted(), Rectangle{});
  sheet.canvas.fill({4, 5, 3, 2}, kRed);
  EXPECT_EQ(sheet.canvas.painted(), (Rectangle{4, 5, 3, 2}));
  sheet.canvas.line(0, 9, 2, 9, kWhite);
  EXPECT_EQ(sheet.canvas.painted(), (Rectangle{0, 5, 7, 5}));
  sheet.canvas.fill({15, -3, 50, 4}, 0x80FFFFFF);
  EXPECT_EQ(sheet.canvas.painted(), (Rectangle{0, 0, 20, 10}));
}

TEST(Canvas, TextIsTheLettersPointByPoint) {
  Sheet sheet(20, 10);
  EXPECT_EQ(sheet.canvas.text(1, 1, "Sã1", kWhite), 1 + 3 * kLetterWidth);
  EXPECT_EQ(sheet.drawn(),
            "....................\n"
            "..####..##.#...#....\n"
            ".#.....#.##...##....\n"
            ".#.............#....\n"
            "..###...####...#....\n"
            ".....#.#...#...#....\n"
            ".....#.#..##...#....\n"
            ".####...##.#..###...\n"
            "....................\n"
            "....................\n");
}

TEST(Canvas, AScaleMakesEachPointASquare) {
  Sheet plain(40, 8), large(120, 24);
  plain.canvas.text(0, 0, "Azul +3", kWhite);
  large.canvas.text(0, 0, "Azul +3", kWhite, 3);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 120; ++x)
      ASSERT_EQ(large.canvas.at(x, y), plain.canvas.at(x / 3, y / 3)) << x << "," << y;
}

TEST(Canvas, UnknownCharactersAreABox) {
  Sheet unknown(6, 8), box(6, 8);
  unknown.canvas.text(0, 0, "\u4E00", kWhite);
  box.canvas.frame({0, 0, 5, 7}, kWhite);
  EXPECT_EQ(unknown.drawn(), box.drawn());
}

TEST(Canvas, FramesKeepWithinTheirRectangle) {
  Sheet sheet(9, 6);
  sheet.canvas.frame({1, 1, 7, 5}, kWhite);
  sheet.canvas.frame({3, 2, 3, 3}, kRed, 2);  // nothing is left within
  EXPECT_EQ(sheet.drawn(),
            ".........\n"
            ".#######.\n"
            ".#.rrr.#.\n"
            ".#.rrr.#.\n"
            ".#.rrr.#.\n"
            ".#######.\n");
}

TEST(Canvas, LinesGoFromEndToEnd) {
  Sheet sheet(8, 5);
  sheet.canvas.line(0, 0, 6, 3, kWhite);
  sheet.canvas.line(7, 4, 7, 2, kRed);
  sheet.canvas.line(1, 4, 1, 4, kRed);
  EXPECT_EQ(sheet.drawn(),
            "#.......\n"
            ".##.....\n"
            "...##..r\n"
            ".....##r\n"
            ".r.....r\n");
}

TEST(Canvas, ATranslucentColourIsMixedOnce) {
  Sheet sheet(4, 4);
  sheet.canvas.fill({0, 0, 4, 4}, 0xFF0A64C8);
  const Argb half = 0x80FF0000;
  // (255 * 128 + 10 * 127) / 255 = 132.98, 100 * 127 / 255 = 49.8, 200 * 127 / 255 = 99.6
  const Argb mixed = 0xFF853264;
  sheet.canvas.fill({1, 1, 1, 1}, half);
  EXPECT_EQ(sheet.canvas.at(1, 1), mixed);
  sheet.canvas.fill({0, 0, 4, 4}, 0xFF0A64C8);
  sheet.canvas.frame({0, 0, 4, 4}, half);  // the corners belong to two sides
  sheet.canvas.line(1, 1, 2, 2, half);
  for (const auto& [x, y] : {std::pair{0, 0}, {3, 0}, {0, 3}, {3, 3}, {0, 2}, {1, 1}, {2, 2}})
    EXPECT_EQ(sheet.canvas.at(x, y), mixed) << x << "," << y;
  EXPECT_EQ(sheet.canvas.at(2, 1), 0xFF0A64C8);
  sheet.canvas.fill({0, 0, 4, 4}, 0x00FFFFFF);
  EXPECT_EQ(sheet.canvas.at(1, 1), mixed);
}

TEST(Canvas, WithinTheClipAllIsAsWithoutOne) {
  std::mt19937 random(5);
  const auto number = [&](int low, int high) {
    return std::uniform_int_distribution(low, high)(random);
  };
  const Rectangle clip{7, 5, 20, 11};
  for (int round = 0; round < 400; ++round) {
    Sheet whole(40, 30), clipped(40, 30);
    clipped.canvas.set_clip(clip);
    const int x = number(-60, 60), y = number(-60, 60), w = number(-5, 90), h = number(-5, 90);
    const int kind = round % 4, scale = number(1, 3);
    for (Canvas* canvas : {&whole.canvas, &clipped.canvas}) switch (kind) {
        case 0: canvas->fill({x, y, w, h}, 0x66FFFFFF); break;
        case 1: canvas->frame({x, y, w, h}, kWhite, scale); break;
        case 2: canvas->line(x, y, w, h, kWhite); break;
        default: canvas->text(x, y, "texto \u2192 \u00E7", 0x99FFFFFF, scale);
      }
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 40; ++i) {
        const bool within = i >= 7 && i < 27 && j >= 5 && j < 16;
        ASSERT_EQ(clipped.canvas.at(i, j), within ? whole.canvas.at(i, j) : kBlack)
            << "kind " << kind << " at " << i << "," << j;
      }
  }
}

TEST(Canvas, FarCoordinatesAreHarmless) {
  Sheet sheet(4, 3);
  sheet.canvas.fill({kFar, kFar, kFar, kFar}, kWhite);
  sheet.canvas.fill({-kFar, -kFar, kFar, kFar}, kWhite);
  sheet.canvas.frame({-kFar, -kFar, kFar, kFar}, kWhite, kFar);
  sheet.canvas.text(kFar, 0, "abc", kWhite, 5);
  sheet.canvas.text(0, -kFar, "abc", kWhite, kFar);
  EXPECT_EQ(sheet.drawn(), "....\n....\n....\n");
  sheet.canvas.line(-kFar, -kFar, kFar, kFar, kWhite);
  EXPECT_EQ(sheet.drawn(), "#...\n.#..\n..#.\n");
  sheet.canvas.set_clip({-5, -5, 7, kFar});
  EXPECT_EQ(sheet.canvas.clip(), (Rectangle{0, 0, 2, 3}));
  sheet.canvas.set_clip({9, 9, 4, 4});
  sheet.canvas.fill({0, 0, 4, 3}, kRed);
  EXPECT_EQ(sheet.drawn(), "#...\n.#..\n..#.\n");
  sheet.canvas.clip_nothing();
  sheet.canvas.fill({-kFar, 1, kFar, 1}, kRed);
  sheet.canvas.fill({2, 1, kFar, 1}, kRed);
  EXPECT_EQ(sheet.drawn(), "#...\n.#rr\n..#.\n");
}

TEST(Canvas, RowsMayBeFartherApartThanTheyAreWide) {
  std::vector<Argb> pixels(4 + 4 + 3, kBlack);
  Canvas canvas(pixels, {3, 3}, 4);
  canvas.fill({0, 0, 3, 3}, kWhite);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    EXPECT_EQ(pixels[i], i % 4 == 3 ? kBlack : kWhite) << i;
  EXPECT_THROW(Canvas(pixels, {3, 4}, 4), std::invalid_argument);
  EXPECT_THROW(Canvas(pixels, {5, 1}, 4), std::invalid_argument);
  EXPECT_THROW(Canvas(pixels, {4, 3}), std::invalid_argument);
  EXPECT_THROW(Canvas(pixels, {-1, 1}), std::invalid_argument);
}

TEST(Canvas, LegibleIsWhatStandsOut) {
  EXPECT_EQ(legible_on({0, 0, 0}), kWhite);
  EXPECT_EQ(legible_on({255, 255, 0}), kBlack);
  EXPECT_EQ(legible_on({0, 0, 255}), kWhite);
  EXPECT_EQ(legible_on({0, 200, 0}), kBlack);
}

}  // namespace
}  // namespace sir::viewer
