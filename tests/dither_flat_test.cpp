// What is flat, on pictures of known make and against the rule written a second time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "quant/flat_areas.h"

namespace sir::quant {
namespace {

using Flags = std::vector<std::uint8_t>;

Rgb8 grey(int level) {
  const auto byte = static_cast<std::uint8_t>(level);
  return {byte, byte, byte};
}

/// An image by a function of column and row.
template <typename Colour>
Planes painted(ImageSize size, Colour colour) {
  Planes image(size);
  std::size_t pixel = 0;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column, ++pixel)
      image.set(pixel, colour(column, row));
  return image;
}

std::size_t flat_pixels(const Planes& image) {
  const Flags flat = flat_areas(image);
  return static_cast<std::size_t>(std::count(flat.begin(), flat.end(), 1));
}

/// How much of a pixel lies within a disc, by 16 x 16 samples.
double coverage(int column, int row, double x, double y, double radius) {
  int inside = 0;
  for (int i = 0; i < 256; ++i)
    inside += std::hypot(column + (i % 16 + 0.5) / 16 - x, row + (i / 16 + 0.5) / 16 - y) < radius;
  return inside / 256.0;
}

TEST(FlatAreas, TheWholeImageInOneColourIsFlat) {
  const Planes image = painted({40, 30}, [](int, int) { return Rgb8{3, 200, 77}; });
  EXPECT_EQ(flat_areas(image), Flags(1200, 1));
}

TEST(FlatAreas, AreNotSmall) {
  // On noise, so that nothing else is flat: bars of 31 and 32 pixels in the middle row.
  for (const int length : {31, 32}) {
    const Planes image = painted({64, 5}, [&](int column, int row) {
      if (row == 2 && column >= 9 && column < 9 + length) return Rgb8{200, 10, 10};
      return grey((column * 37 + row * 71) % 97);
    });
    EXPECT_EQ(flat_pixels(image), length == 32 ? 32u : 0u);
  }
}

TEST(FlatAreas, HangTogetherBySidesAlone) {
  // Two blocks of 20 pixels that touch at a corner are two areas.
  const Planes image = painted({10, 8}, [](int column, int row) {
    return (column < 5) == (row < 4) ? grey(0) : grey(column * 10 + row + 100);
  });
  EXPECT_EQ(flat_pixels(image), 0u);
}

TEST(FlatAreas, DiscsOnAGroundWithHardEdges) {
  const Planes image = painted({60, 50}, [](int column, int row) {
    return std::hypot(column - 30, row - 20) < 15 ? Rgb8{40, 90, 160} : Rgb8{190, 180, 170};
  });
  EXPECT_EQ(flat_pixels(image), 3000u);
}

TEST(FlatAreas, SmoothedEdgesDoNotMakeASlope) {
  for (const int contrast : {150, 60, 30}) {
    const Planes image = painted({80, 80}, [&](int column, int row) {
      const double share = coverage(column, row, 40.3, 39.6, 20);
      return grey(static_cast<int>(std::floor(60 + contrast * share + 0.5)));
    });
    const Flags flat = flat_areas(image);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const bool whole = image.at(i) == grey(60) || image.at(i) == grey(60 + contrast);
      EXPECT_TRUE(flat[i] || !whole) << contrast << " " << i;
    }
  }
}

TEST(FlatAreas, NorDoesRingingBesideThem) {
  // A bar with the overshoots of a good filter: 2 levels beside the edge, and 1 beside that.
  const Planes image = painted({60, 20}, [](int column, int) {
    constexpr int kEdge[] = {100, 99, 102, 150, 198, 201, 200};
    return grey(kEdge[std::clamp(std::min(column - 17, 43 - column), 0, 6)]);
  });
  const Flags flat = flat_areas(image);
  EXPECT_TRUE(flat[5]);
  EXPECT_TRUE(flat[30]);
  EXPECT_TRUE(flat[55]);
}

TEST(FlatAreas, StripsOfASlopeAreNone) {
  for (const int width : {1, 2, 3, 8, 20, 40})
    for (const int step : {1, 2, 4}) {
      const auto level = [&](int along) { return grey(20 + along / width * step); };
      EXPECT_EQ(flat_pixels(painted({160, 33}, [&](int x, int) { return level(x); })), 0u)
          << width << " " << step;
      EXPECT_EQ(flat_pixels(painted({33, 160}, [&](int, int y) { return level(y); })), 0u);
      EXPECT_EQ(flat_pixels(painted({100, 60}, [&](int x, int y) { return level(x + y); })), 0u);
    }
}

TEST(FlatAreas, StairsOfMoreThanAStepAre) {
  EXPECT_EQ(flat_pixels(painted({160, 33}, [](int x, int) { return grey(x / 8 * 5); })), 160u * 33);
}

TEST(FlatAreas, ARadialSlopeHasNone) {
  const Planes image = painted({200, 160}, [](int column, int row) {
    const double r = std::hypot(column - 100, row - 80) / 130;
    return grey(static_cast<int>(std::floor(180 - 60 * r * r + 0.5)));
  });
  EXPECT_EQ(flat_pixels(image), 0u);
}

TEST(FlatAreas, ASlopeBesideAnObjectIsOneStill) {
  // A sky in strips of 6 rows, a house with an edge before it, a flat ground below.
  const Planes image = painted({120, 120}, [](int column, int row) {
    if (row >= 90) return Rgb8{60, 120, 50};
    if (column >= 40 && column < 70 && row >= 30) return Rgb8{150, 40, 40};
    return Rgb8{90, 140, static_cast<std::uint8_t>(240 - row / 6)};
  });
  const Flags flat = flat_areas(image);
  for (std::size_t i = 0; i < flat.size(); ++i)
    EXPECT_EQ(flat[i] != 0, image.at(i).b < 100) << i % 120 << " " << i / 120;
}

TEST(FlatAreas, NoiseOfLessThanAStepIsNotFlat) {
  std::mt19937 random(3);
  const Planes image = painted(
      {120, 90}, [&](int, int row) { return grey(100 + row / 30 + (random() % 12 == 0 ? 1 : 0)); });
  EXPECT_EQ(flat_pixels(image), 0u);
}

/// The rule once more: areas by flooding, borders by walking outwards.
Flags by_flooding(const Planes& image) {
  const int width = image.size.width, height = image.size.height;
  const auto pixel = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
  const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < height; };
  constexpr int kWays[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  Flags flat(image.size.pixels()), done(flat.size());
  for (int y0 = 0; y0 < height; ++y0)
    for (int x0 = 0; x0 < width; ++x0) {
      if (done[pixel(x0, y0)]) continue;
      std::vector<std::pair<int, int>> area{{x0, y0}};
      done[pixel(x0, y0)] = 1;
      int border = 0, slope = 0;
      for (std::size_t n = 0; n < area.size(); ++n) {
        const auto [x, y] = area[n];
        for (const auto& [dx, dy] : kWays) {
          if (!inside(x + dx, y + dy)) continue;
          const std::size_t next = pixel(x + dx, y + dy);
          if (image.at(next) == image.at(pixel(x0, y0))) {
            if (!done[next]) area.emplace_back(x + dx, y + dy);
            done[next] = 1;
            continue;
          }
          ++border;
          bool smooth = true;
          for (int i = 1; i <= 4 && inside(x + i * dx, y + i * dy); ++i) {
            const Rgb8 a = image.at(pixel(x + i * dx, y + i * dy));
            const Rgb8 b = image.at(pixel(x + (i - 1) * dx, y + (i - 1) * dy));
            smooth &= std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) < 5;
          }
          slope += smooth;
        }
      }
      if (area.size() >= 32 && (border == 0 || 3 * slope < border))
        for (const auto& [x, y] : area) flat[pixel(x, y)] = 1;
    }
  return flat;
}

TEST(FlatAreas, AreTheRulesOnRandomPictures) {
  std::mt19937 random(5);
  std::size_t flat = 0, other = 0;
  for (int n = 0; n < 400; ++n) {
    const ImageSize size{static_cast<int>(1 + random() % 40), static_cast<int>(1 + random() % 40)};
    const int levels = static_cast<int>(2 + random() % 3), block = static_cast<int>(1 + n % 4);
    const int step = static_cast<int>(1 + random() % 8);
    std::vector<int> coarse(1600);
    for (int& level : coarse) level = static_cast<int>(random()) & 0xFF;
    const Planes image = painted(size, [&](int column, int row) {
      const int at = row / block * 40 + column / block;
      return grey(90 + coarse[static_cast<std::size_t>(at)] % levels * step);
    });
    const Flags flags = flat_areas(image);
    ASSERT_EQ(flags, by_flooding(image)) << n;
    for (const auto flag : flags) ++(flag ? flat : other);
  }
  EXPECT_GT(flat, 1000u);
  EXPECT_GT(other, 1000u);
}

TEST(FlatAreas, OfTheSmallestImages) {
  EXPECT_TRUE(flat_areas(Planes(ImageSize{0, 0})).empty());
  EXPECT_TRUE(flat_areas(Planes(ImageSize{0, 9})).empty());
  EXPECT_EQ(flat_areas(Planes(ImageSize{1, 1})), Flags(1, 0));
  EXPECT_EQ(flat_areas(Planes(ImageSize{32, 1})), Flags(32, 1));
  EXPECT_EQ(flat_areas(Planes(ImageSize{1, 32})), Flags(32, 1));
}

}  // namespace
}  // namespace sir::quant
