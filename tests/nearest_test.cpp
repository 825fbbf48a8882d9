// The fast search equals the exhaustive one, index for index; the approximate one errs
// by no more than its lattice.
#include "quant/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "quant/choose.h"
#include "quant/inverse_map.h"
#include "quant/shown_through.h"

namespace sir::quant {
namespace {

/// The definition (thesis 3.5), once more.
int by_definition(Rgb8 c, const Lut& lut, const IndexSet& reserved = {}) {
  int best = -1, least = 0;
  for (int i = 255; i >= 0; --i) {
    if (reserved[static_cast<std::size_t>(i)]) continue;
    const Rgb8 e = seen(lut.entry[static_cast<std::size_t>(i)], lut.dac);
    const int d = (e.r - c.r) * (e.r - c.r) + (e.g - c.g) * (e.g - c.g) + (e.b - c.b) * (e.b - c.b);
    if (best < 0 || d <= least) {
      best = i;
      least = d;
    }
  }
  return best;
}

/// Codes of `levels` neighbouring levels; low = kAnywhere puts them anywhere.
constexpr unsigned kAnywhere = 64;
Lut random_lut(std::mt19937& random, std::size_t colours, unsigned low, unsigned levels) {
  std::vector<DacCode> codes(colours);
  if (low == kAnywhere) low = static_cast<unsigned>(random()) % (65 - levels);
  for (DacCode& code : codes)
    for (auto& level : code) level = static_cast<std::uint8_t>(low + random() % levels);
  return make_lut(codes);
}

Planes noise(unsigned seed, unsigned low = 0, unsigned levels = 256) {
  std::mt19937 random(seed);
  Planes image(ImageSize{128, 96});
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(low + random() % levels);
  return image;
}

Planes ramps() {
  Planes image(ImageSize{256, 64});
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    image.set(i, {static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(i / 256 * 4),
                  static_cast<std::uint8_t>(255 - i % 256 / 2)});
  return image;
}

void expect_all_equal(const Planes& image, const Lut& lut, const IndexSet& reserved = {}) {
  const auto fast = map_to_lut(image, lut, Mapping::exact, reserved);
  ASSERT_EQ(fast.size(), image.size.pixels());
  ASSERT_EQ(fast, map_exhaustively(image, lut, reserved));
  for (std::size_t i = 0; i < fast.size(); ++i)
    ASSERT_EQ(fast[i], by_definition(image.at(i), lut, reserved));
}

TEST(NearestEntry, TiesTakeTheLowestIndex) {
  // Codes 0 and 2 are seen as 0 and 8; grey 4 lies half way.
  const Lut lut = make_lut(std::vector<DacCode>{{63, 63, 63}, {2, 2, 2}, {0, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(nearest_entry({4, 4, 4}, lut), 1);
  EXPECT_EQ(nearest_entry({3, 4, 4}, lut), 2);
  EXPECT_EQ(nearest_entry({5, 4, 4}, lut), 1);
  EXPECT_EQ(nearest_entry({0, 0, 0}, lut), 2);
  Planes image(ImageSize{1, 1});
  image.set(0, {4, 4, 4});
  EXPECT_EQ(map_to_lut(image, lut), std::vector<std::uint8_t>{1});
}

TEST(NearestSearch, KeepsACandidateThatIsNearestOnlyAtACorner) {
  // Seen as 8 and 24: equally far from 16, the corner of a cube in which 24
  // is nearer to everything else.
  const Lut lut = make_lut(std::vector<DacCode>{{2, 2, 2}, {6, 6, 6}});
  EXPECT_EQ(NearestSearch(lut)({17, 16, 16}), 1);
  EXPECT_EQ(NearestSearch(lut)({16, 16, 16}), 0);
}

TEST(NearestEntry, AnExactColourMapsToItself) {
  std::mt19937 random(11);
  const Lut lut = random_lut(random, 256, 0, 64);
  NearestSearch search(lut);
  for (std::size_t i = 0; i < 256; ++i) {
    const std::size_t found = nearest_entry(seen(lut.entry[i]), lut);
    EXPECT_LE(found, i);
    EXPECT_EQ(lut.entry[found], lut.entry[i]);
    EXPECT_EQ(search(seen(lut.entry[i])), found);
  }
}

TEST(MapToLut, EqualsTheDefinitionOnChosenLuts) {
  for (const Planes& image : {noise(1), noise(2, 100, 3), noise(3, 0, 60), ramps()})
    for (const Space space : {Space::rgb, Space::hsv})
      for (const Method method : {Method::frequency, Method::median}) {
        ChooseOptions options;
        options.space = space;
        options.method = method;
        expect_all_equal(image, choose_lut(image, options));
      }
}

TEST(MapToLut, EqualsTheDefinitionOnAnyLut) {
  std::mt19937 random(12);
  const Planes pictures[] = {noise(4), ramps()};
  for (const std::size_t colours : {1, 2, 5, 100, 256})
    for (const unsigned levels : {1u, 2u, 4u, 64u})
      for (const Planes& picture : pictures)
        expect_all_equal(picture, random_lut(random, colours, kAnywhere, levels));
}

TEST(MapToLut, EqualsTheDefinitionOnAGridFullOfTies) {
  std::vector<DacCode> codes;
  for (int i = 0; i < 256; ++i)
    codes.push_back({static_cast<std::uint8_t>(i / 64 * 21),
                     static_cast<std::uint8_t>(i / 8 % 8 * 9),
                     static_cast<std::uint8_t>(i % 8 * 9)});
  std::mt19937 random(13);
  std::shuffle(codes.begin(), codes.end(), random);
  expect_all_equal(noise(5), make_lut(codes));
  expect_all_equal(ramps(), make_lut(codes));
}

TEST(NearestSearch, EqualsTheDefinitionAllOverTheCube) {
  std::mt19937 random(14);
  const Lut lut = random_lut(random, 256, 0, 64);
  NearestSearch search(lut);
  for (std::uint32_t key = 0; key < 1u << 24; key += 37) {
    const Rgb8 colour{static_cast<std::uint8_t>(key >> 16), static_cast<std::uint8_t>(key >> 8),
                      static_cast<std::uint8_t>(key)};
    ASSERT_EQ(search(colour), nearest_entry(colour, lut)) << key;
  }
}

int square_distance(Rgb8 a, Rgb8 b) {
  return (a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b);
}

// Codes 1, 3, 5, 7, 9 are seen as 4, 12, 20, 28, 36: the middles of the first five cells
// of an axis, but for half a level. The later ones come first, so that a colour half-way
// between two belongs to the cell that it lies in.
TEST(InverseMap, IsExactWhereEntriesAreTheCellsCentres) {
  std::vector<DacCode> codes;
  for (int i = 124; i >= 0; --i)
    codes.push_back({static_cast<std::uint8_t>(i / 25 * 2 + 1),
                     static_cast<std::uint8_t>(i / 5 % 5 * 2 + 1),
                     static_cast<std::uint8_t>(i % 5 * 2 + 1)});
  const Lut lut = make_lut(codes);
  Planes image(ImageSize{40, 1600});
  for (int i = 0; i < 64000; ++i)
    image.set(static_cast<std::size_t>(i),
              {static_cast<std::uint8_t>(i / 1600), static_cast<std::uint8_t>(i / 40 % 40),
               static_cast<std::uint8_t>(i % 40)});
  EXPECT_EQ(map_to_lut(image, lut, Mapping::approximate), map_exhaustively(image, lut));
  EXPECT_EQ(shown_through(image, lut, Mapping::approximate), shown_through(image, lut));
}

// By the definition, from centres in half levels.
TEST(InverseMap, TakesTheEntryNearestToTheCellsCentre) {
  std::mt19937 random(15);
  const Lut lut = random_lut(random, 200, 0, 64);
  InverseMap map(lut);
  for (int n = 0; n < 3000; ++n) {
    const Rgb8 low{static_cast<std::uint8_t>(random() % 32 * 8),
                   static_cast<std::uint8_t>(random() % 32 * 8),
                   static_cast<std::uint8_t>(random() % 32 * 8)};
    std::size_t best = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < 256; ++i) {
      const Rgb8 e = seen(lut.entry[i]);
      const double r = e.r - (low.r + 3.5), g = e.g - (low.g + 3.5), b = e.b - (low.b + 3.5);
      const double distance = r * r + g * g + b * b;
      if (distance >= least) continue;
      least = distance;
      best = i;
    }
    const auto within = [&](std::uint8_t edge) {
      return static_cast<std::uint8_t>(edge + random() % 8);
    };
    ASSERT_EQ(map({within(low.r), within(low.g), within(low.b)}), best);
  }
}

TEST(InverseMap, ErrsByACellsDiagonalAtMost) {
  std::mt19937 random(16);
  double worst = 0;
  std::size_t wrong = 0;
  for (const std::size_t colours : {2, 40, 256}) {
    for (const unsigned levels : {3u, 12u, 64u}) {
      const Lut lut = random_lut(random, colours, kAnywhere, levels);
      InverseMap map(lut);
      for (int n = 0; n < 40000; ++n) {
        const Rgb8 colour{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                          static_cast<std::uint8_t>(random())};
        const int exact = square_distance(colour, seen(lut.entry[nearest_entry(colour, lut)]));
        const int got = square_distance(colour, seen(lut.entry[map(colour)]));
        ASSERT_GE(got, exact);
        wrong += got != exact;
        worst = std::max(worst, std::sqrt(got) - std::sqrt(exact));
      }
    }
  }
  EXPECT_LE(worst, InverseMap::kWorst);
  EXPECT_GT(worst, 1);  // it is not the exact search in disguise
  EXPECT_GT(wrong, 0u);
  // Near the bound: seen as 0 and 8, of which 0 is nearer to the centre 3.5, the entries
  // are 7 and 1 levels away on each axis.
  const Lut corner = make_lut(std::vector<DacCode>{{0, 0, 0}, {2, 2, 2}});
  EXPECT_EQ(nearest_entry({7, 7, 7}, corner), 1);
  EXPECT_EQ(InverseMap(corner)({7, 7, 7}), 0);
}

TEST(InverseMap, IsUsedWhereItIsAskedFor) {
  std::mt19937 random(17);
  const Lut lut = random_lut(random, 256, 0, 64);
  const Planes image = noise(6);
  EXPECT_EQ(map_to_lut(image, lut), map_to_lut(image, lut, Mapping::exact));
  EXPECT_NE(map_to_lut(image, lut), map_to_lut(image, lut, Mapping::approximate));
}

TEST(MapToLut, EqualsTheDefinitionForAnyDac) {
  std::mt19937 random(18);
  for (const DacBits& dac : {DacBits{{5, 6, 5}}, DacBits{{8, 8, 8}}, DacBits{{1, 2, 3}}}) {
    std::vector<DacCode> codes(256);
    for (DacCode& code : codes)
      for (std::size_t c = 0; c < 3; ++c)
        code[c] = static_cast<std::uint8_t>(random() & static_cast<unsigned>(dac.max_code(c)));
    expect_all_equal(noise(7), make_lut(codes, dac));
    expect_all_equal(ramps(), make_lut(codes, dac));
  }
}

TEST(MapToLut, OfNoPixelsIsEmpty) {
  EXPECT_TRUE(map_to_lut(Planes(ImageSize{0, 0}), Lut{}, Mapping::approximate).empty());
  EXPECT_TRUE(map_to_lut(Planes(ImageSize{0, 0}), Lut{}).empty());
}

}  // namespace
}  // namespace sir::quant
