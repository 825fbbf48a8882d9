#include "eltek/crt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "eltek/dac.h"
#include "tests/tube_oracle.h"

namespace sir::eltek {
namespace {

constexpr std::array<test::Xy, 3> kSmpteC{{{.630L, .340L}, {.310L, .595L}, {.155L, .070L}}};
constexpr test::Xy kD65{.3127L, .3290L};

using Codes = std::array<quant::DacCode, 256>;

/// Random codes and random indices, equal ones side by side now and then.
struct Made {
  IndexedScreen screen;
  Codes codes{};
  explicit Made(ImageSize size, unsigned seed, const quant::DacBits& dac = {}) {
    std::mt19937 random(seed);
    screen.size = size;
    screen.dac = dac;
    for (std::size_t i = 0; i < 256; ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        codes[i][c] = static_cast<std::uint8_t>(random() % (1u << dac.bits[c]));
      screen.palette[i] = dac_colour(codes[i], dac);
    }
    for (std::size_t i = 0; i < size.pixels(); ++i)
      screen.indices.push_back(static_cast<std::uint8_t>(random() % 256));
  }

  /// Light of a pixel in long double, without any effect.
  test::Three light(int column, int row) const {
    const auto at = static_cast<std::size_t>(row * screen.size.width + column);
    const quant::DacCode& code = codes[screen.indices[at]];
    test::Three voltages{};
    for (std::size_t c = 0; c < 3; ++c)
      voltages[c] = code[c] / static_cast<long double>(screen.dac.max_code(c));
    return test::tube_light(kSmpteC, kD65, 2.2L, voltages);
  }
};

void expect_near(Rgb8 byte, const test::Three& light, int most = 1) {
  EXPECT_NEAR(byte.r, test::srgb_byte(light[0]), most);
  EXPECT_NEAR(byte.g, test::srgb_byte(light[1]), most);
  EXPECT_NEAR(byte.b, test::srgb_byte(light[2]), most);
}

CrtOptions with(int scale, bool aspect = false, double spot = 0, double scan_lines = 0) {
  return {{}, scale, aspect, spot, scan_lines};
}

TEST(Crt, AColourMapShowsEachEntrysCodes) {
  for (const quant::DacBits& dac :
       {quant::DacBits{}, quant::DacBits{{5, 6, 5}}, quant::DacBits{{1, 2, 8}}}) {
    const Made made({40, 30}, 7, dac);
    const Crt crt;
    const Screen shown = crt.show(made.screen);
    const auto palette = crt.palette(made.screen);
    ASSERT_EQ(shown.size, made.screen.size);
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 40; ++column) {
        const auto at = shown.offset(column, row);
        expect_near(shown.pixels[at], made.light(column, row));
        EXPECT_EQ(shown.pixels[at], palette[made.screen.indices[at]]);
      }
  }
}

TEST(Crt, BlackIsExact) {
  IndexedScreen black{{8, 8}, std::vector<std::uint8_t>(64), {}, {}};
  for (const CrtOptions& options : {with(1), with(3, true, 1, 0.5)})
    for (const Rgb8 pixel : Crt(options).show(black).pixels) EXPECT_EQ(pixel, Rgb8{});
}

TEST(Crt, ScaleRepeatsPixelsExactly) {
  const Made made({30, 20}, 3);
  const Screen once = Crt().show(made.screen);
  for (const int scale : {2, 3, 8}) {
    const Screen shown = Crt(with(scale)).show(made.screen);
    ASSERT_EQ(shown.size, (ImageSize{30 * scale, 20 * scale}));
    for (int row = 0; row < shown.size.height; ++row)
      for (int column = 0; column < shown.size.width; ++column)
        ASSERT_EQ(shown.at(column, row), once.at(column / scale, row / scale));
  }
}

TEST(Crt, AspectMakesTheScreenFourToThree) {
  EXPECT_EQ(Crt(with(1, true)).shown_size({1024, 780}), (ImageSize{1040, 780}));
  EXPECT_EQ(Crt(with(3, true)).shown_size({1024, 780}), (ImageSize{3120, 2340}));
  EXPECT_EQ(Crt(with(1, true)).shown_size({640, 480}), (ImageSize{650, 480}));
  EXPECT_EQ(Crt(with(1, true)).shown_size({10, 10}), (ImageSize{10, 10}));
}

// 64 columns become 65: the j-th takes j parts of 64 from the column before it.
TEST(Crt, AspectMixesLight) {
  const Made made({64, 4}, 11);
  const Screen shown = Crt(with(1, true)).show(made.screen);
  ASSERT_EQ(shown.size, (ImageSize{65, 4}));
  for (int row = 0; row < 4; ++row)
    for (int j = 0; j < 65; ++j) {
      test::Three mixed{};
      const test::Three before = made.light(std::max(j - 1, 0), row);
      const test::Three own = made.light(std::min(j, 63), row);
      for (std::size_t c = 0; c < 3; ++c) mixed[c] = (before[c] * j + own[c] * (64 - j)) / 64;
      expect_near(shown.at(j, row), mixed);
    }
}

IndexedScreen two_colours(ImageSize size, int first_white_column) {
  IndexedScreen screen{size, {}, {}, {}};
  screen.palette[1] = {255, 255, 255};
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column)
      screen.indices.push_back(column >= first_white_column ? 1 : 0);
  return screen;
}

TEST(Crt, ASpotMakesAnEdgeAGaussiansIntegral) {
  constexpr int kScale = 8;
  for (const double spot : {0.5, 1.0, 2.0}) {
    const Screen shown = Crt(with(kScale, false, spot)).show(two_colours({40, 3}, 20));
    for (int row = 0; row < shown.size.height; row += 5)
      for (int column = 0; column < shown.size.width; ++column) {
        const double x = (column + 0.5) / kScale - 20;
        const double light = std::erfc(-x / (spot * std::numbers::sqrt2)) / 2;
        // The mean over an eighth of a pixel is not quite the middle's light.
        const double off = 0.0002 / spot / spot;
        EXPECT_GE(shown.at(column, row).g, test::srgb_byte(light - off) - 1) << column;
        EXPECT_LE(shown.at(column, row).g, test::srgb_byte(light + off) + 1) << column;
      }
  }
}

TEST(Crt, AnEvenAreaStaysEvenUnderSpotScaleAndAspect) {
  IndexedScreen even{{20, 10}, std::vector<std::uint8_t>(200, 9), {}, {}};
  even.palette[9] = dac_colour({40, 20, 60});
  const Rgb8 plain = Crt().palette(even)[9];
  for (const CrtOptions& options : {with(1, true), with(3, true, 1.3), with(2, false, 5)})
    for (const Rgb8 pixel : Crt(options).show(even).pixels) ASSERT_EQ(pixel, plain);
}

TEST(Crt, ScanLinesTakeTheLightBetweenLines) {
  const IndexedScreen white = two_colours({4, 5}, 0);
  for (const int scale : {3, 4, 7})
    for (const double depth : {0.25, 0.5, 1.0}) {
      const Screen shown = Crt(with(scale, false, 0, depth)).show(white);
      double mean = 0;
      for (int row = 0; row < shown.size.height; ++row) {
        const double place = (row % scale + 0.5) / scale;
        const double light = 1 - depth * (1 + std::cos(2 * std::numbers::pi * place)) / 2;
        mean += light / shown.size.height;
        EXPECT_NEAR(shown.at(1, row).r, test::srgb_byte(light), 1) << row;
        // Symmetric, and brightest in the middle of the line.
        EXPECT_EQ(shown.at(1, row), shown.at(1, shown.size.height - 1 - row));
      }
      EXPECT_NEAR(mean, 1 - depth / 2, 1e-12);
      EXPECT_GT(shown.at(1, scale / 2).r, shown.at(1, 0).r);
    }
}

TEST(Crt, TrueColoursAreThoseOfADacOfEightBits) {
  const Made made({50, 40}, 5, {{8, 8, 8}});
  Screen plain{made.screen.size, {}};
  for (const std::uint8_t index : made.screen.indices)
    plain.pixels.push_back(made.screen.palette[index]);
  for (const CrtOptions& options : {with(1), with(3, true, 0.7, 0.4)}) {
    const Crt crt(options);
    const Screen one = crt.show(plain), other = crt.show(made.screen);
    ASSERT_EQ(one.size, other.size);
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
      EXPECT_NEAR(one.pixels[i].r, other.pixels[i].r, 1);
      EXPECT_NEAR(one.pixels[i].g, other.pixels[i].g, 1);
      EXPECT_NEAR(one.pixels[i].b, other.pixels[i].b, 1);
    }
  }
}

TEST(Crt, TheSamePictureEachTime) {
  const Made made({100, 60}, 9);
  const CrtOptions options = with(3, true, 0.6, 0.5);
  EXPECT_EQ(Crt(options).show(made.screen), Crt(options).show(made.screen));
}

TEST(Crt, RefusesWhatCannotBe) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const CrtOptions& options :
       {with(0), with(9), with(1, false, -1), with(1, false, 0.05), with(1, false, 5.1),
        with(1, false, kNan), with(3, false, 0, -0.1), with(3, false, 0, 1.1),
        with(3, false, 0, kNan), with(2, false, 0, 0.5)}) {
    EXPECT_FALSE(options.valid());
    EXPECT_THROW(Crt{options}, std::invalid_argument);
  }
  EXPECT_TRUE(with(1).is_colour_map());
  EXPECT_FALSE(with(2).is_colour_map());
  EXPECT_FALSE(with(1, true).is_colour_map());
  EXPECT_FALSE(with(1, false, 1).is_colour_map());
}

}  // namespace
}  // namespace sir::eltek
