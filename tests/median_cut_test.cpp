// Median cut on cases worked by hand, and what must not change its result.
#include "quant/median_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "quant/choose.h"
#include "quant/frequency.h"

namespace sir::quant {
namespace {

using Codes = std::vector<DacCode>;

/// Code of the mean of cells.
DacCode mean(const std::vector<Cell>& cells) {
  PointSum sum;
  for (const Cell& cell : cells) sum.add(cell.at, cell.pixels);
  return RgbGrid().code(sum);
}

Cell blue(int at, std::uint64_t pixels) { return {{0, 0, at}, pixels}; }

Codes cut(const std::vector<Cell>& cells, std::size_t entries,
          SplitOrder order = SplitOrder::pixels) {
  return median_cut(cells, entries, order, RgbGrid());
}

TEST(MedianCut, OneBoxIsTheMeanOfAllPixels) {
  EXPECT_EQ(cut({blue(0, 1), blue(31, 2)}, 1), (Codes{{0, 0, 42}}));
  EXPECT_EQ(cut({{{31, 0, 10}, 1}, {{0, 31, 10}, 1}}, 1), (Codes{{32, 32, 20}}));
}

TEST(MedianCut, CutsWhereTheRunningTotalIsNearestToHalf) {
  const std::vector<Cell> cells{blue(0, 4), blue(5, 3), blue(6, 2), blue(20, 2)};  // 4 7 9 of 11
  EXPECT_EQ(cut(cells, 2), (Codes{mean({cells[0]}), mean({cells[1], cells[2], cells[3]})}));
}

TEST(MedianCut, EquallyNearTakesTheLowerCoordinate) {
  const std::vector<Cell> cells{blue(3, 2), blue(9, 2), blue(12, 2)};  // 2, 4 of 6
  EXPECT_EQ(cut(cells, 2), (Codes{mean({cells[0]}), mean({cells[1], cells[2]})}));
}

TEST(MedianCut, BothHalvesAreOccupied) {
  const std::vector<Cell> last{blue(1, 1), blue(2, 1), blue(30, 100)};
  EXPECT_EQ(cut(last, 2), (Codes{mean({last[0], last[1]}), mean({last[2]})}));
  const std::vector<Cell> first{blue(1, 100), blue(2, 1), blue(30, 1)};
  EXPECT_EQ(cut(first, 2), (Codes{mean({first[0]}), mean({first[1], first[2]})}));
}

TEST(MedianCut, TakesTheLongestAxisThenTheFirst) {
  // Green is longest, although red and blue would part other cells.
  const std::vector<Cell> green{{{0, 0, 5}, 1}, {{4, 1, 0}, 1}, {{0, 9, 5}, 1}, {{4, 10, 0}, 1}};
  EXPECT_EQ(cut(green, 2), (Codes{mean({green[0], green[1]}), mean({green[2], green[3]})}));
  // Red and blue are equally long: red.
  const std::vector<Cell> tie{{{0, 0, 7}, 1}, {{1, 0, 0}, 1}, {{6, 0, 7}, 1}, {{7, 0, 0}, 1}};
  EXPECT_EQ(cut(tie, 2), (Codes{mean({tie[0], tie[1]}), mean({tie[2], tie[3]})}));
}

// Boxes: A = blue 0..1 with 10 pixels, B = blue 20..31 with 4.
const std::vector<Cell> kUneven{blue(0, 5), blue(1, 5), blue(20, 1), blue(22, 1), blue(31, 2)};

TEST(SplitOrders, PixelsSplitsTheFullestBoxFirst) {
  // {0,1 | 20..31} would be 10:4; the first cut is after 0 or 1: 5 or 10 of 14, so after 0.
  EXPECT_EQ(cut(kUneven, 2),
            (Codes{mean({kUneven[0]}), mean({kUneven[1], kUneven[2], kUneven[3], kUneven[4]})}));
  EXPECT_EQ(cut(kUneven, 3), (Codes{mean({kUneven[0]}), mean({kUneven[1]}),
                                    mean({kUneven[2], kUneven[3], kUneven[4]})}));
}

TEST(SplitOrders, DifferOnTheSameCells) {
  const std::vector<Cell> cells{blue(0, 20),  blue(1, 20),  blue(2, 20),  blue(3, 20),
                                blue(10, 12), blue(20, 12), blue(25, 12), blue(31, 12)};
  // First cut 0..2 | 3..31 (60 of 128 is nearest to 64).
  const auto from = [&](std::size_t a, std::size_t b) {
    return mean({cells.begin() + static_cast<std::ptrdiff_t>(a),
                 cells.begin() + static_cast<std::ptrdiff_t>(b)});
  };
  // pixels: 68 > 60 splits 3,10 | 20,25,31 (32 of 68); then 0..2 with 60.
  EXPECT_EQ(cut(cells, 4, SplitOrder::pixels),
            (Codes{from(0, 1), from(1, 3), from(3, 5), from(5, 8)}));
  // breadth: 0..2 first.
  EXPECT_EQ(cut(cells, 3, SplitOrder::breadth), (Codes{from(0, 1), from(1, 3), from(3, 8)}));
  EXPECT_EQ(cut(cells, 5, SplitOrder::breadth),
            (Codes{from(0, 1), from(1, 2), from(2, 3), from(3, 5), from(5, 8)}));
  // longest: 3..31, then 20..31 (11) before 3..10 (7), 0..2 last.
  EXPECT_EQ(cut(cells, 4, SplitOrder::longest),
            (Codes{from(0, 3), from(3, 5), from(5, 6), from(6, 8)}));
}

TEST(SplitOrders, EqualBoxesAreSplitInTheListsOrder) {
  const std::vector<Cell> cells{blue(0, 1), blue(1, 1), blue(10, 1), blue(11, 1)};
  for (const SplitOrder order : {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest})
    EXPECT_EQ(cut(cells, 3, order),
              (Codes{mean({cells[0]}), mean({cells[1]}), mean({cells[2], cells[3]})}));
}

TEST(MedianCut, NeverSplitsASingleCellAndStopsWhenNoneIsLeft) {
  const std::vector<Cell> cells{blue(0, 1000), blue(7, 1), blue(8, 1), blue(9, 1)};
  const Codes all{mean({cells[0]}), mean({cells[1]}), mean({cells[2]}), mean({cells[3]})};
  for (const SplitOrder order : {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest}) {
    EXPECT_EQ(cut(cells, 4, order), all);
    EXPECT_EQ(cut(cells, 256, order), all);
    EXPECT_TRUE(cut({}, 5, order).empty());
    EXPECT_TRUE(cut(cells, 0, order).empty());
  }
}

TEST(MedianCut, HsvBoxesLieWithinTheirPlane) {
  const HsvGrid grid;
  // Saturations lie apart by 20, values by 10: the cut is by saturation.
  const std::vector<Cell> cells{
      {{12, 9, 10}, 1}, {{12, 9, 20}, 1}, {{12, 29, 10}, 1}, {{12, 29, 20}, 1}};
  PointSum pale, full;
  pale.add(cells[0].at, 1);
  pale.add(cells[1].at, 1);
  full.add(cells[2].at, 1);
  full.add(cells[3].at, 1);
  EXPECT_EQ(median_cut(cells, 2, SplitOrder::pixels, grid),
            (Codes{grid.code(pale), grid.code(full)}));
}

Planes random_image(unsigned seed) {
  std::mt19937 random(seed);
  Planes image(ImageSize{60, 50});
  const unsigned levels = seed % 2 == 0 ? 256 : 9;
  for (auto& plane : image.channel)
    for (auto& byte : plane)
      byte = static_cast<std::uint8_t>(random() % levels * 255 / (levels - 1));
  return image;
}

TEST(MedianCut, DoesNotDependOnTheOrderOfCells) {
  std::mt19937 random(7);
  for (unsigned seed = 0; seed < 10; ++seed) {
    auto cells = count_cells(random_image(seed), RgbGrid());
    const Codes before = cut(cells, 100);
    std::shuffle(cells.begin(), cells.end(), random);
    EXPECT_EQ(cut(cells, 100), before);
  }
}

TEST(ChooseLut, DoesNotDependOnTheOrderOfPixels) {
  std::mt19937 random(8);
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Planes image = random_image(seed);
    std::vector<std::size_t> order(image.size.pixels());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    Planes shuffled(image.size);
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.set(i, image.at(order[i]));
    for (const Space space : {Space::rgb, Space::hsv})
      for (const Method method : {Method::frequency, Method::median})
        for (const SplitOrder split :
             {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest}) {
          ChooseOptions options;
          options.space = space;
          options.method = method;
          options.split = split;
          EXPECT_EQ(choose_lut(image, options), choose_lut(shuffled, options));
        }
  }
}

}  // namespace
}  // namespace sir::quant
