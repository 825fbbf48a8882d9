// Absolute frequency, and the sharing out of entries among planes.
#include "quant/frequency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "quant/allocation.h"
#include "quant/choose.h"

namespace sir::quant {
namespace {

using Shares = std::vector<std::size_t>;

DacCode grey(int cell) {
  PointSum sum;
  sum.add({cell, cell, cell}, 1);
  return RgbGrid().code(sum);
}

Cell grey_cell(int at, std::uint64_t pixels) { return {{at, at, at}, pixels}; }

TEST(MostFrequent, StandFirst) {
  const std::vector<Cell> cells{grey_cell(1, 5), grey_cell(2, 9), grey_cell(3, 1), grey_cell(4, 7)};
  EXPECT_EQ(most_frequent(cells, 3, RgbGrid()), (std::vector<DacCode>{grey(2), grey(4), grey(1)}));
}

TEST(MostFrequent, TiesTakeTheLowestCell) {
  std::vector<Cell> cells;
  for (int i = 0; i < 32; ++i) cells.push_back(grey_cell(i, i % 2 == 0 ? 3 : 4));
  std::vector<DacCode> expected;
  for (int i = 1; i < 32; i += 2) expected.push_back(grey(i));
  for (int i = 0; i < 8; i += 2) expected.push_back(grey(i));
  EXPECT_EQ(most_frequent(cells, 20, RgbGrid()), expected);
}

TEST(MostFrequent, FewerCellsThanEntries) {
  const std::vector<Cell> cells{grey_cell(1, 5), grey_cell(2, 9)};
  EXPECT_EQ(most_frequent(cells, 10, RgbGrid()).size(), 2u);
  EXPECT_TRUE(most_frequent(cells, 0, RgbGrid()).empty());
}

TEST(Allocate, LargestRemaindersGetTheRest) {
  // The quotas are 85.33, 86.19 and 84.48, then 0.5, 0.5 and 9.
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{100, 1}, {101, 1}, {99, 1}}),
            (Shares{85, 86, 85}));
  EXPECT_EQ(allocate(10, std::vector<PlaneClaim>{{1, 1}, {1, 1}, {18, 1}}), (Shares{1, 0, 9}));
}

TEST(Allocate, TiesGoToMorePixelsThenToTheFirst) {
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{100, 1}, {100, 2}, {100, 1}}),
            (Shares{85, 86, 85}));
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{100, 1}, {100, 1}, {100, 2}}),
            (Shares{85, 85, 86}));
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{100, 2}, {100, 2}, {100, 2}}),
            (Shares{86, 85, 85}));
}

TEST(Allocate, FewCellsGetOneEntryEach) {
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{100, 1}, {156, 9}}), (Shares{100, 156}));
  EXPECT_EQ(allocate(256, std::vector<PlaneClaim>{{3, 1}, {0, 0}, {2, 9}}), (Shares{3, 0, 2}));
  EXPECT_TRUE(allocate(256, std::vector<PlaneClaim>{}).empty());
}

TEST(Allocate, AddsUpAndKeepsToTheQuota) {
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    std::vector<PlaneClaim> planes(1 + random() % 37);
    const std::size_t most = random() % 2 == 0 ? 12 : 900;
    std::size_t all = 0;
    for (PlaneClaim& plane : planes) {
      plane = {random() % most, random() % 4};
      all += plane.cells;
    }
    const Shares shares = allocate(256, planes);
    ASSERT_EQ(std::accumulate(shares.begin(), shares.end(), std::size_t{0}),
              std::min<std::size_t>(all, 256));
    for (std::size_t p = 0; p < planes.size(); ++p) {
      ASSERT_LE(shares[p], planes[p].cells);
      if (all <= 256) continue;
      ASSERT_GE((shares[p] + 1) * all, 256 * planes[p].cells + 1);  // share > quota - 1
      ASSERT_LT(shares[p] * all, 256 * planes[p].cells + all);      // share < quota + 1
    }
  }
}

ChooseOptions by_frequency(Space space) {
  ChooseOptions options;
  options.method = Method::frequency;
  options.space = space;
  return options;
}

TEST(ChooseByFrequency, RgbTakesThe256MostFrequentCells) {
  // Cell number i (blue and green coordinates) appears once, but 3 of them more often.
  Planes image(ImageSize{310, 1});
  const auto colour = [](std::size_t i) {
    const auto green = static_cast<std::uint8_t>(8 * (i / 32));
    return Rgb8{0, green, static_cast<std::uint8_t>(8 * (i % 32))};
  };
  for (std::size_t i = 0; i < 300; ++i) image.set(i, colour(i));
  for (std::size_t i = 300; i < 305; ++i) image.set(i, colour(299));
  for (std::size_t i = 305; i < 309; ++i) image.set(i, colour(270));
  image.set(309, colour(4));
  const Lut lut = choose_lut(image, by_frequency(Space::rgb));
  EXPECT_EQ(lut.chosen, 256u);
  const auto entry = [](int green, int blue) {
    PointSum sum;
    sum.add({0, green, blue}, 1);
    return RgbGrid().code(sum);
  };
  EXPECT_EQ(lut.entry[0], entry(9, 11));
  EXPECT_EQ(lut.entry[1], entry(8, 14));
  EXPECT_EQ(lut.entry[2], entry(0, 4));
  EXPECT_EQ(lut.entry[3], entry(0, 0));
  EXPECT_EQ(lut.entry[255], entry(7, 29));  // cells 0 to 253 but 4
}

TEST(ChooseByFrequency, HsvSharesByCellsNotByPixels) {
  // 1 red cell of 5000 pixels; 300 bluish cells of one pixel each.
  Planes image(ImageSize{5300, 1});
  for (std::size_t i = 0; i < 5000; ++i) image.set(i, {255, 0, 0});
  const HsvGrid grid;
  std::vector<bool> seen_cell(grid.size());
  std::size_t at = 5000;
  for (int low = 0; low < 200; ++low)
    for (int high = 60; high < 256; ++high) {
      const Rgb8 blue{static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(low),
                      static_cast<std::uint8_t>(high)};
      if (high <= low || at == 5300) continue;
      const std::size_t cell = grid.cell(blue);
      if (grid.point(cell)[0] != 24 || seen_cell[cell]) continue;
      seen_cell[cell] = true;
      image.set(at++, blue);
    }
  ASSERT_EQ(at, 5300u);
  const Lut lut = choose_lut(image, by_frequency(Space::hsv));
  EXPECT_EQ(lut.chosen, 256u);
  EXPECT_EQ(lut.entry[0], (DacCode{63, 0, 0}));
  for (std::size_t i = 1; i < 256; ++i) EXPECT_GT(lut.entry[i][2], lut.entry[i][0]) << i;
}

}  // namespace
}  // namespace sir::quant
