// Dithering: what it must average to, what it must leave alone, and Floyd and Steinberg's
// algorithm written a second time.
#include "quant/dither.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include "quant/banding.h"
#include "quant/flat_areas.h"
#include "quant/image_pair.h"
#include "quant/known_entries.h"
#include "quant/nearest.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

using Indices = std::vector<std::uint8_t>;

Rgb8 grey(int level) {
  const auto byte = static_cast<std::uint8_t>(level);
  return {byte, byte, byte};
}

Lut greys(const std::vector<int>& codes) {
  std::vector<DacCode> entries;
  for (const int code : codes) {
    const auto level = static_cast<std::uint8_t>(code);
    entries.push_back({level, level, level});
  }
  return make_lut(entries);
}

Lut random_lut(unsigned seed, std::size_t colours) {
  std::mt19937 random(seed);
  std::vector<DacCode> entries(colours);
  for (DacCode& entry : entries)
    for (auto& level : entry) level = static_cast<std::uint8_t>(random() % 64);
  return make_lut(entries);
}

Indices dithered(const Planes& image, const Lut& lut, Dither kind) {
  NearestSearch nearest(lut);
  return dither(image, lut, kind, std::ref(nearest));
}

class Dithering : public testing::TestWithParam<Dither> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Dithering, testing::Values(Dither::floyd, Dither::blue_noise),
                         [](const auto& kind) {
                           return kind.param == Dither::floyd ? "Floyd" : "BlueNoise";
                         });

/// Two levels in a chessboard: no area of one colour, so nothing in it is flat.
Planes chessboard(ImageSize size, int level) {
  Planes image(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const std::size_t width = static_cast<std::size_t>(size.width);
    image.set(i, grey(level + static_cast<int>((i % width + i / width) % 2)));
  }
  return image;
}

double mean_light(const Planes& image) {
  double sum = 0;
  for (const std::uint8_t byte : image.channel[0]) sum += light_of_coded(byte / 255.0);
  return sum / static_cast<double>(image.size.pixels());
}

// Of a pixel's error 1 - kErrorShare is lost, and no error is larger than from the light where
// the nearest entry changes to the farther of the two; a mixture ends with one unpaid, an image
// loses some at its ends. That holds for colours between two entries, away from both.
TEST_P(Dithering, AveragesInLinearLight) {
  for (const auto& [low, high] : {std::pair{0, 63}, {10, 40}, {30, 38}}) {
    const Lut lut = greys({low, high});
    const int dark = seen_byte(low), bright = seen_byte(high);
    const auto light = [](double byte) { return light_of_coded(byte / 255); };
    const double middle = light((dark + bright) / 2.0);
    const double largest = std::max(middle - light(dark), light(bright) - middle);
    const double lost = 1 - kErrorShare + (GetParam() == Dither::blue_noise ? 1.0 / 16 : 0);
    const int away = (bright - dark) / 5;
    for (int level = dark + away; level + 1 <= bright - away; level += 3) {
      const Planes image = chessboard({128, 128}, level);
      const Planes shown = as_seen(image.size, dithered(image, lut, GetParam()), lut);
      EXPECT_NEAR(mean_light(shown), mean_light(image), lost * largest)
          << dark << " " << bright << " " << level;
    }
  }
}

TEST_P(Dithering, LeavesFlatAreasAlone) {
  // A disc cut by the image's border, on a ground, beside a slope.
  Planes image(ImageSize{120, 80});
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const double x = static_cast<double>(i % 120), y = static_cast<double>(i / 120);
    image.set(i, x >= 70                          ? grey(static_cast<int>(30 + x / 2 + y / 3))
                 : std::hypot(x - 5, y - 30) < 20 ? Rgb8{133, 71, 59}
                                                  : Rgb8{201, 190, 187});
  }
  const Lut lut = random_lut(2, 100);
  const Indices indices = dithered(image, lut, GetParam());
  std::size_t mixed = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint8_t nearest = nearest_entry(image.at(i), lut);
    if (i % 120 >= 70) mixed += indices[i] != nearest;
    EXPECT_TRUE(i % 120 >= 70 || indices[i] == nearest) << i;
  }
  EXPECT_GT(mixed, 400u);  // of 4000
}

TEST_P(Dithering, ShowsTheLutsColoursAsTheyAre) {
  const Lut lut = random_lut(3, 60);
  std::mt19937 random(4);
  Planes image(ImageSize{90, 70});
  for (std::size_t i = 0; i < image.size.pixels(); ++i) image.set(i, lut.seen(random() % 60));
  EXPECT_EQ(as_seen(image.size, dithered(image, lut, GetParam()), lut), image);

  // Also among pixels of other colours, whose errors come to them.
  std::vector<std::uint8_t> own(image.size.pixels(), 1);
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    if (random() % 2 || i % 90 < 30) {
      image.set(i, unpacked(static_cast<std::uint32_t>(random()) & 0xFFFFFF));
      own[i] = 0;
    }
  const Planes shown = as_seen(image.size, dithered(image, lut, GetParam()), lut);
  for (std::size_t i = 0; i < own.size(); ++i)
    EXPECT_TRUE(!own[i] || shown.at(i) == image.at(i)) << i;
}

TEST_P(Dithering, ASlowSlopeLosesItsFalseContours) {
  Planes image(ImageSize{400, 64});
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    image.set(i, grey(40 + static_cast<int>(i % 400) / 4));
  const Lut lut = greys({8, 16, 24, 32, 40});
  const Planes shown = as_seen(image.size, dithered(image, lut, GetParam()), lut);
  // No bands in the means of columns, eight at a time.
  const auto worst = [&](const Planes& seen) {
    double most = 0;
    for (std::size_t first = 8; first + 16 <= 400; first += 8) {
      double difference = 0;
      for (std::size_t row = 0; row < 64; ++row)
        for (std::size_t column = first; column < first + 8; ++column) {
          const std::size_t i = row * 400 + column;
          difference +=
              light_of_coded(seen.at(i).r / 255.0) - light_of_coded(image.at(i).r / 255.0);
        }
      most = std::max(most, std::abs(difference) / 512);
    }
    return most;
  };
  EXPECT_LT(worst(shown), 0.5 * worst(shown_through(image, lut)));
}

// With entries at every code of the DAC. (banding() takes any two pairs of equal pixels side by
// side for even stretches, which blue noise has everywhere and error diffusion has less often.)
TEST(DitherFloyd, LeavesLessOfFalseContours) {
  Planes image(ImageSize{510, 64});
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    image.set(i, grey(static_cast<int>(i % 510) / 2));
  std::vector<int> codes;
  for (int code = 0; code < 64; ++code) codes.push_back(code);
  const Lut lut = greys(codes);
  const Planes shown = as_seen(image.size, dithered(image, lut, Dither::floyd), lut);
  EXPECT_LT(banding(image, shown), 0.75 * banding(image, shown_through(image, lut)));
}

TEST_P(Dithering, AsksOnceForAColour) {
  const Lut lut = random_lut(5, 30);
  const Planes image = test::random_planes({60, 50}, 6);
  std::map<std::uint32_t, int> asked;
  NearestSearch search(lut);
  dither(image, lut, GetParam(), [&](Rgb8 colour) {
    ++asked[packed(colour)];
    return search(colour);
  });
  for (const auto& [colour, times] : asked) EXPECT_EQ(times, 1) << colour;
}

TEST_P(Dithering, TakesTheCallersMeasure) {
  // All it wants is the last entry.
  const Planes image = test::random_planes({20, 20}, 7);
  EXPECT_EQ(dither(image, random_lut(8, 256), GetParam(), [](Rgb8) { return std::uint8_t{255}; }),
            Indices(400, 255));
}

TEST_P(Dithering, OfTheSmallestImagesAndLuts) {
  for (const ImageSize size : {ImageSize{1, 1}, {1, 50}, {50, 1}, {2, 2}, {0, 0}, {0, 7}}) {
    const Planes image = test::random_planes(size, 9);
    EXPECT_EQ(dithered(image, random_lut(10, 200), GetParam()).size(), size.pixels());
    EXPECT_EQ(dithered(image, greys({17}), GetParam()), Indices(size.pixels(), 0));
  }
  // One pixel alone has nobody to share its error with.
  const Lut two = greys({0, 63});
  EXPECT_EQ(dithered(chessboard({1, 1}, 100), two, Dither::floyd), Indices{0});
}

TEST_P(Dithering, IsTheSameEachTime) {
  const Planes image = test::random_planes({100, 80}, 11);
  const Lut lut = random_lut(12, 256);
  const Indices once = dithered(image, lut, GetParam());
  EXPECT_EQ(dithered(image, lut, GetParam()), once);
  EXPECT_NE(once, map_to_lut(image, lut));
}

TEST(DitherNone, IsTheMapping) {
  const Planes image = test::random_planes({64, 48}, 13);
  const Lut lut = random_lut(14, 256);
  EXPECT_EQ(dithered(image, lut, Dither::none), map_to_lut(image, lut));
}

TEST(DitherBlueNoise, DependsOnColourAndPlaceAlone) {
  Planes image = test::random_planes({80, 70}, 15);
  const Lut lut = random_lut(16, 256);
  const Indices before = dithered(image, lut, Dither::blue_noise);
  std::mt19937 random(17);
  for (int n = 0; n < 20; ++n) {
    Planes changed = image;
    const std::size_t at = random() % image.size.pixels();
    changed.set(at, unpacked(static_cast<std::uint32_t>(random()) & 0xFFFFFF));
    Indices after = dithered(changed, lut, Dither::blue_noise);
    after[at] = before[at];
    EXPECT_EQ(after, before) << at;
  }
}

TEST(DitherFloyd, PassesItsErrorOn) {
  Planes image = test::random_planes({80, 70}, 15);
  const Lut lut = random_lut(16, 256);
  const Indices before = dithered(image, lut, Dither::floyd);
  image.set(80 * 20 + 40, {255, 255, 255});
  const Indices after = dithered(image, lut, Dither::floyd);
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + 80 * 20 + 40, after.begin()));
  EXPECT_FALSE(
      std::equal(before.begin() + 80 * 20 + 41, before.end(), after.begin() + 80 * 20 + 41));
}

/// Floyd and Steinberg once more: errors of the whole image, by coordinates, by the formulas.
Indices floyd_once_more(const Planes& image, const Lut& lut) {
  const int width = image.size.width, height = image.size.height;
  const auto flat = flat_areas(image);
  std::vector<double> error(3 * image.size.pixels());
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
  const auto light = [](double byte) { return light_of_coded(byte / 255); };
  Indices indices(image.size.pixels());
  for (int y = 0; y < height; ++y)
    for (int n = 0; n < width; ++n) {
      const int way = y % 2 ? -1 : 1, x = y % 2 ? width - 1 - n : n;
      const std::size_t pixel = at(x, y);
      indices[pixel] = nearest_entry(image.at(pixel), lut);
      if (flat[pixel]) continue;
      const Rgb8 nearest = lut.seen(indices[pixel]);
      const std::array<int, 3> near{nearest.r, nearest.g, nearest.b};
      std::array<int, 3> own{}, look{};
      std::array<double, 3> wanted{};
      int off = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        own[k] = image.channel[k][pixel];
        off = std::max(off, std::abs(own[k] - near[k]));
      }
      const int reach = std::clamp(off * off / 4, 8, 255);
      for (std::size_t k = 0; k < 3; ++k) {
        wanted[k] = light(own[k]) + error[3 * pixel + k];
        for (int byte = 1; byte < 256; ++byte)
          if (light(byte - 0.5) <= wanted[k]) look[k] = byte;
        look[k] = std::min(std::clamp(look[k], own[k] - reach, own[k] + reach), 255);
      }
      if (off > 0)
        indices[pixel] =
            nearest_entry({static_cast<std::uint8_t>(look[0]), static_cast<std::uint8_t>(look[1]),
                           static_cast<std::uint8_t>(look[2])},
                          lut);
      const Rgb8 taken = lut.seen(indices[pixel]);
      const std::array<int, 3> seen{taken.r, taken.g, taken.b};
      const auto give = [&](int dx, int dy, int sixteenths) {
        if (x + dx < 0 || x + dx >= width || y + dy >= height) return;
        for (std::size_t k = 0; k < 3; ++k)
          error[3 * at(x + dx, y + dy) + k] +=
              sixteenths / 16.0 * (0.85 * (wanted[k] - light(seen[k])));
      };
      give(way, 0, 7);
      give(-way, 1, 3);
      give(0, 1, 5);
      give(way, 1, 1);
    }
  return indices;
}

TEST(DitherFloyd, IsFloydAndSteinbergs) {
  for (unsigned seed = 20; seed < 26; ++seed) {
    const Planes image = test::random_planes({31, 24}, seed);
    const Lut lut = random_lut(seed, seed % 2 ? 256 : 12);
    EXPECT_EQ(dithered(image, lut, Dither::floyd), floyd_once_more(image, lut)) << seed;
  }
  const Planes board = chessboard({50, 40}, 100);
  EXPECT_EQ(dithered(board, greys({20, 30}), Dither::floyd),
            floyd_once_more(board, greys({20, 30})));
}

}  // namespace
}  // namespace sir::quant
