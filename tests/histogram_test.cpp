// Counting an image's colours in both grids.
#include "quant/histogram.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <random>
#include <stdexcept>

#include "quant/choose.h"

namespace sir::quant {
namespace {

Planes random_image(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Planes image(ImageSize{width, height});
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(random() % 40 * 6);
  return image;
}

Histogram counted_one_by_one(const Planes& image, const Grid& grid, std::size_t every) {
  std::map<std::size_t, std::uint64_t> counts;
  for (std::size_t i = 0; i < image.size.pixels(); i += every) ++counts[grid.cell(image.at(i))];
  Histogram cells;
  for (const auto& [cell, pixels] : counts) cells.push_back({grid.point(cell), pixels});
  return cells;
}

TEST(Histogram, HoldsOccupiedCellsInTheGridsOrder) {
  Planes image(ImageSize{3, 2});
  image.set(0, {255, 0, 0});
  image.set(1, {0, 0, 7});
  image.set(2, {250, 0, 0});
  image.set(3, {0, 0, 0});
  image.set(4, {0, 8, 0});
  image.set(5, {255, 7, 7});
  EXPECT_EQ(count_cells(image, RgbGrid()),
            (Histogram{{{0, 0, 0}, 2}, {{0, 1, 0}, 1}, {{31, 0, 0}, 3}}));
  EXPECT_EQ(
      count_cells(image, HsvGrid()),
      (Histogram{
          {{0, 28, 29}, 1}, {{0, 29, 28}, 1}, {{0, 29, 29}, 1}, {{36, 0, 0}, 1}, {{36, 0, 1}, 2}}));
}

TEST(Histogram, EqualsCountingOneByOne) {
  const RgbGrid rgb;
  const HsvGrid hsv;
  for (const int width : {1, 2, 31, 1023, 1024, 1025, 2048, 3001})
    for (const std::size_t every : {1, 2, 3, 7, 1024, 5000}) {
      const Planes image = random_image(width, 3, static_cast<unsigned>(width));
      ASSERT_EQ(count_cells(image, rgb, every), counted_one_by_one(image, rgb, every));
      ASSERT_EQ(count_cells(image, hsv, every), counted_one_by_one(image, hsv, every));
    }
}

TEST(Histogram, ASampleStartsAtTheFirstPixel) {
  Planes image(ImageSize{5, 1});
  for (std::size_t i = 0; i < 5; ++i) image.set(i, {static_cast<std::uint8_t>(8 * i), 0, 0});
  EXPECT_EQ(count_cells(image, RgbGrid(), 2),
            (Histogram{{{0, 0, 0}, 1}, {{2, 0, 0}, 1}, {{4, 0, 0}, 1}}));
  EXPECT_EQ(count_cells(image, RgbGrid(), 100), (Histogram{{{0, 0, 0}, 1}}));
  EXPECT_THROW(count_cells(image, RgbGrid(), 0), std::invalid_argument);
}

TEST(Histogram, OfNoPixelsIsEmpty) {
  EXPECT_TRUE(count_cells(Planes(ImageSize{0, 0}), RgbGrid()).empty());
  EXPECT_TRUE(count_cells(Planes(ImageSize{0, 5}), HsvGrid(), 3).empty());
}

TEST(OccupiedCells, CountsBothGridsGreysIncluded) {
  Planes greys(ImageSize{256, 1});
  for (std::size_t i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i);
    greys.set(i, {level, level, level});
  }
  EXPECT_EQ(occupied_cells(greys).rgb, 32u);
  EXPECT_EQ(occupied_cells(greys).hsv, 30u);
  EXPECT_EQ(occupied_cells(greys, {}, 256).rgb, 1u);
  HsvGridShape fine;
  ASSERT_TRUE(parse_grid("36x30x256", fine));
  EXPECT_EQ(occupied_cells(greys, fine).hsv, 256u);
}

}  // namespace
}  // namespace sir::quant
