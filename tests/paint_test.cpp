// Picking colours by hue, saturation and value, and showing them as others.
#include "quant/paint.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "quant/color_space.h"

namespace sir::quant {
namespace {

PaintRule rule(const std::string& text) {
  PaintRule parsed;
  EXPECT_TRUE(parse_rule(text, parsed)) << text;
  return parsed;
}

bool picked(const std::string& ranges, Rgb8 colour) {
  return picks(rule(ranges + " with=keep"), colour);
}

TEST(PaintRule, ReadsRangesAndBrushes) {
  const PaintRule all = rule("v=..0.5 with=255,0,12\t h=350..20  s=0.25");
  EXPECT_EQ(all.hue, (DecimalRange{350 * kBillion, 20 * kBillion}));
  EXPECT_EQ(all.saturation, (DecimalRange{kBillion / 4, kBillion / 4}));
  EXPECT_EQ(all.value, (DecimalRange{0, kBillion / 2}));
  EXPECT_EQ(all.with, (Brush{Brush::Kind::colour, {255, 0, 12}, 0}));
  const PaintRule open = rule("s=.3.. h=12.000000001..360 with=hue:120.5");
  EXPECT_EQ(open.saturation, (DecimalRange{300'000'000, kBillion}));
  EXPECT_EQ(open.hue, (DecimalRange{12'000'000'001, 360 * kBillion}));
  EXPECT_EQ(open.with, (Brush{Brush::Kind::hue, {}, 120'500'000'000}));
  EXPECT_FALSE(open.value);
}

TEST(PaintRule, RefusesWhatIsNone) {
  const PaintRule before = rule("s=0.5.. with=1,2,3");
  for (const char* text : {"",
                           "with=1,2,3",
                           "s=0.3..0.6",
                           "s=0.6..0.3 with=keep",
                           "s=0..1.1 with=keep",
                           "s=-0.1..1 with=keep",
                           "s=+0.1 with=keep",
                           "s=1e-1 with=keep",
                           "s=nan with=keep",
                           "s=0.1234567891 with=keep",
                           "s= with=keep",
                           "s=. with=keep",
                           "s=0.1...0.2.3 with=keep",
                           "s=0,1 with=keep",
                           "h=361 with=keep",
                           "h=0..360.000000001 with=keep",
                           "h=9999999999 with=keep",
                           "x=1 with=keep",
                           "s=0.1 s=0.2 with=keep",
                           "s=0.1 with=keep with=keep",
                           "s=0.1 with=256,0,0",
                           "s=0.1 with=1,2",
                           "s=0.1 with=1,2,3,4",
                           "s=0.1 with=hue:",
                           "s=0.1 with=hue:400",
                           "s=0.1 with=red",
                           "s=0.1 with",
                           "s 0.1 with=keep",
                           "S=0.1 with=keep"}) {
    PaintRule parsed = before;
    EXPECT_FALSE(parse_rule(text, parsed)) << text;
    EXPECT_EQ(parsed.saturation, before.saturation) << text;
    EXPECT_EQ(parsed.with, before.with) << text;
  }
}

TEST(PaintRule, BothEndsBelongToTheRange) {
  // s = 51/255 = 0.2 and v = 153/255 = 0.6, neither of them a double.
  EXPECT_TRUE(picked("s=0.2..0.3", {255, 204, 204}));
  EXPECT_TRUE(picked("s=0.1..0.2", {255, 204, 204}));
  EXPECT_TRUE(picked("s=0.2", {255, 204, 204}));
  EXPECT_FALSE(picked("s=0.200000001..", {255, 204, 204}));
  EXPECT_FALSE(picked("s=..0.199999999", {255, 204, 204}));
  EXPECT_TRUE(picked("v=0.6", {153, 0, 10}));
  EXPECT_FALSE(picked("v=0.6", {154, 0, 10}));
  // s = 1/3 has no decimal: it lies between two neighbours.
  EXPECT_TRUE(picked("s=0.333333333..0.333333334", {3, 2, 2}));
  EXPECT_FALSE(picked("s=0.333333334..", {3, 2, 2}));
  EXPECT_FALSE(picked("s=..0.333333333", {3, 2, 2}));
  // Hue 10 degrees: r = 60, g - b = 10 of chroma 60.
  EXPECT_TRUE(picked("h=10", {60, 10, 0}));
  EXPECT_FALSE(picked("h=10.000000001..20", {60, 10, 0}));
}

TEST(PaintRule, BlackAndWhite) {
  EXPECT_TRUE(picked("v=0", {0, 0, 0}));
  EXPECT_TRUE(picked("s=0", {0, 0, 0}));
  EXPECT_TRUE(picked("s=0 v=1", {255, 255, 255}));
  EXPECT_FALSE(picked("s=0.000000001..", {0, 0, 0}));
}

TEST(PaintRule, HuesWrapAndGreysHaveNone) {
  const Rgb8 red{255, 0, 0}, rose{255, 0, 43}, orange{255, 84, 0}, green{0, 255, 0};
  for (const char* around : {"h=349..20", "h=330..360", "h=360..20", "h=349..0"}) {
    EXPECT_TRUE(picked(around, red)) << around;
    EXPECT_FALSE(picked(around, green)) << around;
  }
  EXPECT_TRUE(picked("h=349..20", rose));  // 349.88
  EXPECT_TRUE(picked("h=349..20", orange));
  EXPECT_FALSE(picked("h=350..20", rose));
  EXPECT_FALSE(picked("h=349..19", orange));
  EXPECT_TRUE(picked("h=0..360", green));
  EXPECT_TRUE(picked("h=20..349", green));
  EXPECT_FALSE(picked("h=20..349", red));
  for (const Rgb8 grey : {Rgb8{0, 0, 0}, Rgb8{9, 9, 9}, Rgb8{255, 255, 255}})
    EXPECT_FALSE(picked("h=0..360", grey));
}

// Every colour of a coarse cube against the real numbers, limits away from ties.
TEST(PaintRule, AgreesWithTheRealNumbers) {
  const PaintRule wrapping =
      rule("h=300.0001..45.0001 s=0.30001..0.80001 v=0.20001..0.90001 with=keep");
  std::size_t count = 0;
  for (int r = 0; r < 256; r += 5)
    for (int g = 0; g < 256; g += 5)
      for (int b = 0; b < 256; b += 5) {
        const Rgb8 colour{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                          static_cast<std::uint8_t>(b)};
        const Hsv hsv = hsv_of(colour);
        const bool expected = (hsv.h >= 300.0001 || hsv.h <= 45.0001) && hsv.s >= 0.30001 &&
                              hsv.s <= 0.80001 && hsv.v >= 0.20001 && hsv.v <= 0.90001 &&
                              !(r == g && g == b);
        ASSERT_EQ(picks(wrapping, colour), expected) << r << " " << g << " " << b;
        count += expected;
      }
  EXPECT_GT(count, 5000u);
}

TEST(Brush, AnotherHueKeepsSaturationAndValue) {
  const Brush blue{Brush::Kind::hue, {}, 240 * kBillion};
  EXPECT_EQ(brushed(blue, {200, 50, 50}), (Rgb8{50, 50, 200}));
  EXPECT_EQ(brushed(blue, {77, 77, 77}), (Rgb8{77, 77, 77}));
  const Brush round{Brush::Kind::hue, {}, 360 * kBillion};
  EXPECT_EQ(brushed(round, {0, 200, 30}), (Rgb8{200, 0, 0}));
  // 10 degrees of chroma 255 is 42.5 above the least byte: rounded up.
  EXPECT_EQ(brushed({Brush::Kind::hue, {}, 10 * kBillion}, {0, 255, 0}), (Rgb8{255, 43, 0}));
}

TEST(Brush, AnotherHueIsHsvToRgb) {
  std::mt19937 random(4);
  for (int i = 0; i < 100'000; ++i) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    const Rgb8 colour{byte(), byte(), byte()};
    const auto tenths = static_cast<std::int64_t>(random() % 3600);
    const Rgb8 got = brushed({Brush::Kind::hue, {}, tenths * (kBillion / 10)}, colour);
    Hsv hsv = hsv_of(colour);
    hsv.h = static_cast<double>(tenths) / 10;
    const Rgb real = hsv_to_rgb(hsv);
    // Nearest, whatever side a tie of the real numbers falls to in double.
    EXPECT_LE(std::abs(got.r - 255 * real.r), 0.5 + 1e-9);
    EXPECT_LE(std::abs(got.g - 255 * real.g), 0.5 + 1e-9);
    EXPECT_LE(std::abs(got.b - 255 * real.b), 0.5 + 1e-9);
  }
}

TEST(Paint, TheFirstRuleThatPicksPaints) {
  Planes image(ImageSize{4, 1});
  const std::array<Rgb8, 4> colours{Rgb8{255, 0, 0}, {0, 255, 0}, {0, 0, 100}, {90, 90, 90}};
  for (std::size_t i = 0; i < 4; ++i) image.set(i, colours[i]);
  // The green that the first rule paints would be picked by the second.
  const std::vector<PaintRule> rules{rule("h=350..10 with=0,255,0"), rule("h=100..140 with=hue:60"),
                                     rule("v=1 with=1,1,1")};
  const Painted kept = paint(image, rules);
  EXPECT_EQ(kept.picked, (std::vector<std::uint64_t>{1, 1, 0}));
  EXPECT_EQ(kept.image.at(0), (Rgb8{0, 255, 0}));
  EXPECT_EQ(kept.image.at(1), (Rgb8{255, 255, 0}));
  EXPECT_EQ(kept.image.at(2), colours[2]);
  EXPECT_EQ(kept.image.at(3), colours[3]);
  const Painted grey = paint(image, rules, Rest::grey);
  EXPECT_EQ(grey.image.at(0), kept.image.at(0));
  EXPECT_EQ(grey.image.at(2), (Rgb8{11, 11, 11}));  // 0.114 * 100 = 11.4
  EXPECT_EQ(grey.image.at(3), colours[3]);
}

TEST(Paint, NothingPickedChangesNothing) {
  Planes image(ImageSize{64, 2});
  for (std::size_t i = 0; i < 128; ++i) image.set(i, {static_cast<std::uint8_t>(i), 20, 20});
  const std::vector<PaintRule> rules{rule("h=90..270 with=0,0,0")};
  const Painted painted = paint(image, rules);
  // Below 20 the hue is 180 degrees.
  EXPECT_EQ(painted.picked, (std::vector<std::uint64_t>{20}));
  const Painted none = paint(image, std::vector<PaintRule>{rule("v=0.9.. with=0,0,0")});
  EXPECT_EQ(none.picked, (std::vector<std::uint64_t>{0}));
  EXPECT_EQ(none.image, image);
}

}  // namespace
}  // namespace sir::quant
