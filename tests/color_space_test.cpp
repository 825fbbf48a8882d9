// RGB and HSV, the bins of the grids, and codes of cells and means.
#include "quant/color_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "quant/dac_code.h"
#include "quant/grid.h"

namespace sir::quant {
namespace {

void expect_hsv(Hsv got, double h, double s, double v) {
  EXPECT_NEAR(got.h, h, 1e-12);
  EXPECT_NEAR(got.s, s, 1e-15);
  EXPECT_NEAR(got.v, v, 1e-15);
}

GridPoint point_of(const Grid& grid, Rgb8 colour) { return grid.point(grid.cell(colour)); }

DacCode code_of_point(const Grid& grid, GridPoint point) {
  PointSum sum;
  sum.add(point, 1);
  return grid.code(sum);
}

TEST(RgbToHsv, PureColoursStandSixtyDegreesApart) {
  expect_hsv(rgb_to_hsv({1, 0, 0}), 0, 1, 1);
  expect_hsv(rgb_to_hsv({1, 1, 0}), 60, 1, 1);
  expect_hsv(rgb_to_hsv({0, 1, 0}), 120, 1, 1);
  expect_hsv(rgb_to_hsv({0, 1, 1}), 180, 1, 1);
  expect_hsv(rgb_to_hsv({0, 0, 1}), 240, 1, 1);
  expect_hsv(rgb_to_hsv({1, 0, 1}), 300, 1, 1);
  expect_hsv(rgb_to_hsv({0.5, 0.25, 0.25}), 0, 0.5, 0.5);
}

TEST(RgbToHsv, GreysHaveNoHueAndKeepTheirValue) {
  expect_hsv(rgb_to_hsv({0, 0, 0}), 0, 0, 0);
  expect_hsv(rgb_to_hsv({0.4, 0.4, 0.4}), 0, 0, 0.4);
  expect_hsv(hsv_of({200, 200, 200}), 0, 0, 200 / 255.0);
}

TEST(RgbToHsv, HueStaysBelow360) {
  EXPECT_LT(rgb_to_hsv({1, 0, 1e-300}).h, 360);
  EXPECT_LT(rgb_to_hsv({1, 0, 1e-17}).h, 360);
  expect_hsv(hsv_of({255, 0, 1}), 360 - 60 / 255.0, 1, 1);
}

TEST(HsvToRgb, UndoesRgbToHsv) {
  std::mt19937 random(1);
  const auto intensity = [&] { return static_cast<double>(random()) / 4294967295.0; };
  for (int i = 0; i < 100000; ++i) {
    const Rgb colour{intensity(), intensity(), intensity()};
    const Rgb back = hsv_to_rgb(rgb_to_hsv(colour));
    ASSERT_NEAR(back.r, colour.r, 1e-14);
    ASSERT_NEAR(back.g, colour.g, 1e-14);
    ASSERT_NEAR(back.b, colour.b, 1e-14);
  }
}

TEST(HsvToRgb, Hue360IsRed) {
  const Rgb red = hsv_to_rgb({360, 1, 1});
  EXPECT_EQ(red.r, 1);
  EXPECT_EQ(red.g, 0);
  EXPECT_EQ(red.b, 0);
}

TEST(HsvOfBytes, AgreesWithTheRoutineInDouble) {
  for (int r = 0; r < 256; r += 5)
    for (int g = 0; g < 256; g += 5)
      for (int b = 0; b < 256; b += 5) {
        const Hsv plain = rgb_to_hsv({r / 255.0, g / 255.0, b / 255.0});
        const Hsv exact = hsv_of({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                  static_cast<std::uint8_t>(b)});
        ASSERT_NEAR(plain.h, exact.h, 1e-10);
        ASSERT_NEAR(plain.s, exact.s, 1e-14);
        ASSERT_EQ(plain.v, exact.v);
      }
}

TEST(RgbGrid, DividesBytesByEight) {
  const RgbGrid grid;
  EXPECT_EQ(grid.size(), 32768u);
  EXPECT_EQ(grid.cell({0, 0, 0}), 0u);
  EXPECT_EQ(grid.cell({255, 255, 255}), 32767u);
  EXPECT_EQ(grid.cell({8, 16, 31}), std::size_t{(1 * 32 + 2) * 32 + 3});
  EXPECT_EQ(point_of(grid, {7, 128, 254}), (GridPoint{0, 16, 31}));
}

TEST(RgbGrid, OfOtherBitsKeepsTheHighestOfEachByte) {
  for (int bits = 1; bits <= RgbGrid::kMaxBits; ++bits) {
    const RgbGrid grid(bits);
    const int levels = 1 << bits, side = 256 / levels;
    EXPECT_EQ(grid.size(), static_cast<std::size_t>(levels * levels * levels));
    for (int byte = 0; byte < 256; ++byte) {
      const auto c = static_cast<std::uint8_t>(byte);
      const int i = byte / side;
      EXPECT_EQ(point_of(grid, {c, 0, 255}), (GridPoint{i, 0, levels - 1})) << bits;
      EXPECT_EQ(point_of(grid, {255, c, 0}), (GridPoint{levels - 1, i, 0})) << bits;
      EXPECT_EQ(point_of(grid, {0, 255, c}), (GridPoint{0, levels - 1, i})) << bits;
      const int code = (2 * 63 * i + levels - 1) / (2 * (levels - 1));
      EXPECT_EQ(code_of_point(grid, {i, 0, 0})[0], code) << bits;
    }
  }
  EXPECT_THROW(RgbGrid(0), std::invalid_argument);
  EXPECT_THROW(RgbGrid(9), std::invalid_argument);
}

TEST(RgbGrid, CodesOfCells) {
  const RgbGrid grid;
  for (int i = 0; i < 32; ++i) {
    const auto code = static_cast<std::uint8_t>((2 * 63 * i + 31) / 62);
    EXPECT_EQ(code_of_point(grid, {i, 0, 31}), (DacCode{code, 0, 63}));
  }
}

TEST(HsvGrid, BordersOfTheHueBins) {
  const HsvGrid grid;
  EXPECT_EQ(point_of(grid, {240, 19, 0}), (GridPoint{0, 29, 27}));   // 4.75 degrees
  EXPECT_EQ(point_of(grid, {240, 20, 0}), (GridPoint{1, 29, 27}));   // 5
  EXPECT_EQ(point_of(grid, {240, 0, 21}), (GridPoint{35, 29, 27}));  // 354.75
  EXPECT_EQ(point_of(grid, {240, 0, 20}), (GridPoint{0, 29, 27}));   // 355
  EXPECT_EQ(point_of(grid, {0, 240, 20}), (GridPoint{13, 29, 27}));  // 125
  EXPECT_EQ(point_of(grid, {0, 20, 240}), (GridPoint{24, 29, 27}));  // 235
}

TEST(HsvGrid, BordersOfTheGreyPlane) {
  const HsvGrid grid;
  EXPECT_EQ(point_of(grid, {60, 48, 48}), (GridPoint{36, 0, 7}));  // S = 1/5
  EXPECT_EQ(point_of(grid, {61, 48, 48}), (GridPoint{0, 6, 7}));
  EXPECT_EQ(point_of(grid, {51, 0, 0}), (GridPoint{36, 0, 6}));  // V = 1/5
  EXPECT_EQ(point_of(grid, {52, 0, 0}), (GridPoint{0, 29, 6}));
  EXPECT_EQ(point_of(grid, {0, 0, 0}), (GridPoint{36, 0, 0}));
  EXPECT_EQ(point_of(grid, {255, 255, 255}), (GridPoint{36, 0, 29}));
}

// The definition of each bin as inequalities between integers, from the
// thesis's own rc, gc, bc: every colour there is.
TEST(HsvGrid, EveryColourLiesInItsBin) {
  const HsvGrid grid;
  std::vector<GridPoint> points;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) points.push_back(grid.point(cell));
  const auto lies_in = [](const GridPoint& bin, int r, int g, int b) {
    const int max = std::max({r, g, b}), min = std::min({r, g, b}), c = max - min;
    const int v = bin[2];
    if (!((2 * v - 1) * 255 <= 58 * max && 58 * max < (2 * v + 1) * 255)) return false;
    if (5 * c <= max || max <= 51) return bin[0] == 36 && bin[1] == 0;
    const int s = bin[1];
    if (!((2 * s - 1) * max <= 58 * c && 58 * c < (2 * s + 1) * max)) return false;
    const int rc = max - r, gc = max - g, bc = max - b;  // all over c
    int degrees = 60 * (bc - gc);
    if (r != max) degrees = g == max ? 60 * (2 * c + rc - bc) : 60 * (4 * c + gc - rc);
    degrees = (degrees + 365 * c) % (360 * c);
    return 10 * bin[0] * c <= degrees && degrees < 10 * (bin[0] + 1) * c;
  };
  std::array<std::uint8_t, 256> red, green, blue;
  for (std::size_t b = 0; b < 256; ++b) blue[b] = static_cast<std::uint8_t>(b);
  std::array<std::uint32_t, 256> cells;
  int wrong = 0, different = 0;
  for (int r = 0; r < 256; ++r)
    for (int g = 0; g < 256; ++g) {
      red.fill(static_cast<std::uint8_t>(r));
      green.fill(static_cast<std::uint8_t>(g));
      grid.locate(red.data(), green.data(), blue.data(), cells);
      for (std::size_t b = 0; b < 256; ++b) {
        wrong += !lies_in(points[cells[b]], r, g, static_cast<int>(b));
        different += cells[b] != grid.cell({red[0], green[0], blue[b]});
      }
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(different, 0);
}

TEST(HsvGrid, ManyAtATimeEqualsOneByOneInAnyShape) {
  std::mt19937 random(2);
  std::vector<std::uint8_t> r(50000), g(50000), b(50000);
  for (std::size_t i = 0; i < r.size(); ++i) {
    r[i] = static_cast<std::uint8_t>(random() >> 24);
    g[i] = i % 3 == 0 ? r[i] : static_cast<std::uint8_t>(random() >> 24);
    b[i] = i % 5 == 0 ? g[i] : static_cast<std::uint8_t>(random() >> 24);
  }
  std::vector<std::uint32_t> cells(r.size());
  for (const char* const text :
       {"1x2x2", "7x5x3", "36x30x30", "360x100x90", "1024x128x128", "16x1024x1024", "35x31x29"}) {
    HsvGridShape shape;
    ASSERT_TRUE(parse_grid(text, shape)) << text;
    shape.grey_s = 0.05;
    shape.grey_v = 0.0;
    const HsvGrid grid(shape);
    grid.locate(r.data(), g.data(), b.data(), cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t cell = grid.cell({r[i], g[i], b[i]});
      ASSERT_EQ(cells[i], cell) << text << ": " << +r[i] << " " << +g[i] << " " << +b[i];
      ASSERT_LT(cell, grid.size());
    }
  }
}

TEST(RgbGrid, ManyAtATimeEqualsOneByOne) {
  std::mt19937 random(3);
  std::array<std::uint8_t, 999> r, g, b;
  for (auto* const plane : {&r, &g, &b})
    for (auto& byte : *plane) byte = static_cast<std::uint8_t>(random() >> 24);
  for (int bits = 1; bits <= RgbGrid::kMaxBits; ++bits) {
    const RgbGrid grid(bits);
    std::array<std::uint32_t, 999> cells;
    grid.locate(r.data(), g.data(), b.data(), cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
      ASSERT_EQ(cells[i], grid.cell({r[i], g[i], b[i]})) << bits;
  }
}

TEST(HsvGrid, LimitsAreExactDecimals) {
  for (int percent = 0; percent <= 100; ++percent) {
    HsvGridShape shape;
    shape.grey_s = percent / 100.0;
    shape.grey_v = 0;
    const HsvGrid by_s(shape);
    shape.grey_s = 0;
    shape.grey_v = percent / 100.0;
    const HsvGrid by_v(shape);
    for (int max = 1; max < 256; ++max) {
      const auto top = static_cast<std::uint8_t>(max);
      for (int c = 1; c <= max; ++c) {
        const bool grey = 100 * c <= percent * max;
        const auto low = static_cast<std::uint8_t>(max - c);
        ASSERT_EQ(point_of(by_s, {top, low, low})[0] == 36, grey)
            << percent << " " << c << "/" << max;
      }
      ASSERT_EQ(point_of(by_v, {top, 0, 0})[0] == 36, 100 * max <= percent * 255)
          << percent << " " << max;
    }
  }
}

TEST(HsvGrid, NumbersCellsByHueSaturationValueAndGreyLast) {
  HsvGridShape shape;
  ASSERT_TRUE(parse_grid("5x4x3", shape));
  const HsvGrid grid(shape);
  EXPECT_EQ(grid.size(), 63u);
  std::size_t cell = 0;
  for (int h = 0; h < 5; ++h)
    for (int s = 0; s < 4; ++s)
      for (int v = 0; v < 3; ++v) EXPECT_EQ(grid.point(cell++), (GridPoint{h, s, v}));
  for (int v = 0; v < 3; ++v) EXPECT_EQ(grid.point(cell++), (GridPoint{5, 0, v}));
}

TEST(HsvGrid, HalfCodesAreRoundedUp) {
  const HsvGrid grid;
  EXPECT_EQ(code_of_point(grid, {1, 29, 29}), (DacCode{63, 11, 0}));  // 10.5
  EXPECT_EQ(code_of_point(grid, {5, 29, 29}), (DacCode{63, 53, 0}));  // 52.5
  EXPECT_EQ(code_of_point(grid, {7, 29, 29}), (DacCode{53, 63, 0}));
  EXPECT_EQ(code_of_point(grid, {13, 29, 29}), (DacCode{0, 63, 11}));
  EXPECT_EQ(code_of_point(grid, {19, 29, 29}), (DacCode{0, 53, 63}));
  EXPECT_EQ(code_of_point(grid, {25, 29, 29}), (DacCode{11, 0, 63}));
  EXPECT_EQ(code_of_point(grid, {31, 29, 29}), (DacCode{63, 0, 53}));
  EXPECT_EQ(code_of_point(grid, {36, 0, 29}), (DacCode{63, 63, 63}));
  PointSum half;  // 31.5
  half.add({36, 0, 0}, 7);
  half.add({36, 0, 29}, 7);
  EXPECT_EQ(grid.code(half), (DacCode{32, 32, 32}));
}

TEST(HsvGrid, CodesAgreeWithTheRoutineInDouble) {
  const HsvGrid grid;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const GridPoint at = grid.point(cell);
    const Rgb colour = at[0] == 36 ? hsv_to_rgb({0, 0, at[2] / 29.0})
                                   : hsv_to_rgb({10.0 * at[0], at[1] / 29.0, at[2] / 29.0});
    const DacCode code = code_of_point(grid, at);
    ASSERT_NEAR(code[0], 63 * colour.r, 0.5 + 1e-9);
    ASSERT_NEAR(code[1], 63 * colour.g, 0.5 + 1e-9);
    ASSERT_NEAR(code[2], 63 * colour.b, 0.5 + 1e-9);
  }
}

TEST(Grids, MeansOfVeryManyPixelsAreExact) {
  std::mt19937 random(4);
  HsvGridShape fine;
  ASSERT_TRUE(parse_grid("16x1024x1024", fine));
  const RgbGrid rgb;
  const HsvGrid hsv;
  const HsvGrid fine_hsv(fine);
  for (const Grid* const grid : {static_cast<const Grid*>(&rgb), static_cast<const Grid*>(&hsv),
                                 static_cast<const Grid*>(&fine_hsv)})
    for (int i = 0; i < 2000; ++i) {
      const GridPoint a = grid->point(random() % grid->size());
      GridPoint b = grid->point(random() % grid->size());
      if (grid->plane(a) != grid->plane(b)) b[0] = a[0];
      const std::uint64_t pa = random() % 5 + 1, pb = random() % 5 + 1;
      PointSum few, many;
      few.add(a, pa);
      few.add(b, pb);
      many.add(a, pa << 36);
      many.add(b, pb << 36);
      ASSERT_EQ(grid->code(few), grid->code(many));
    }
}

TEST(ParseGrid, TakesThreeNumbersWithAnXBetween) {
  HsvGridShape shape;
  EXPECT_TRUE(parse_grid("72x60X50", shape));
  EXPECT_EQ(shape.hues, 72);
  EXPECT_EQ(shape.saturations, 60);
  EXPECT_EQ(shape.values, 50);
  for (const char* const text : {"", "36", "36x30", "36x30x", "36x30x30x", "36x30x30 ", " 36x30x30",
                                 "0x30x30", "36x1x30", "36x30x1", "-1x30x30", "36,30,30",
                                 "1024x1024x1024", "99999999999x30x30", "2000x2x2", "36xx30"}) {
    EXPECT_FALSE(parse_grid(text, shape)) << text;
    EXPECT_EQ(shape.hues, 72) << text;
  }
}

TEST(HsvGrid, RefusesImpossibleShapes) {
  HsvGridShape shape;
  shape.saturations = 1;
  EXPECT_THROW(HsvGrid{shape}, std::invalid_argument);
  shape = {};
  shape.grey_s = 1.5;
  EXPECT_THROW(HsvGrid{shape}, std::invalid_argument);
  shape = {};
  shape.grey_v = -0.1;
  EXPECT_THROW(HsvGrid{shape}, std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
