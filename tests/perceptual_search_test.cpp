// Mapping by the eye, faster, equals comparing every entry, index for index.
#include "quant/perceptual_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include "bench/made_up.h"
#include "quant/choose.h"
#include "tests/cases.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

using test::random_planes;

Rgb8 any_colour(std::mt19937& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
          static_cast<std::uint8_t>(bits >> 16)};
}

/// Codes of the DAC, within `levels` neighbouring ones of each primary.
Lut random_lut(std::mt19937& random, std::size_t colours, const DacBits& dac = {},
               unsigned levels = 256) {
  std::vector<DacCode> codes(colours);
  std::array<unsigned, 3> low{}, width{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto all = static_cast<unsigned>(dac.max_code(c) + 1);
    width[c] = std::min(levels, all);
    low[c] = static_cast<unsigned>(random()) % (all - width[c] + 1);
  }
  for (DacCode& code : codes)
    for (std::size_t c = 0; c < 3; ++c)
      code[c] = static_cast<std::uint8_t>(low[c] + random() % width[c]);
  return make_lut(codes, dac);
}

/// perceptually_nearest once more, from its header's words.
int by_definition(Rgb8 colour, const Lut& lut, ColourMeasure& measure, const IndexSet& reserved) {
  const auto least_by = [&](auto difference) {
    int best = -1;
    double least = 0;
    for (int i = 255; i >= 0; --i) {
      const auto index = static_cast<std::size_t>(i);
      if (reserved[index]) continue;
      const double one = difference(seen(lut.entry[index], lut.dac));
      if (best < 0 || one <= least) {
        best = i;
        least = one;
      }
    }
    return std::pair(best, least);
  };
  const auto [near, difference] =
      least_by([&](Rgb8 entry) { return double{measure.difference(colour, entry)}; });
  if (difference <= double{kFormHolds}) return near;
  const Lab own = lab_of(colour);
  const double limit =
      kOutOfQuestion * least_by([&](Rgb8 entry) { return afar(own, lab_of(entry)); }).second;
  return least_by([&](Rgb8 entry) {
           const Lab other = lab_of(entry);
           return afar(own, other) > limit ? 1e9 : ciede2000(own, other);
         })
      .first;
}

void expect_same(const Lut& lut, std::mt19937& random, int colours, const IndexSet& reserved = {}) {
  PerceptualSearch search(lut, reserved);
  ColourMeasure measure(Goal::perceptual);
  for (int n = 0; n < colours; ++n) {
    const Rgb8 colour = any_colour(random);
    const int expected = by_definition(colour, lut, measure, reserved);
    ASSERT_EQ(int{search(colour)}, expected) << n;
    ASSERT_EQ(int{perceptually_nearest(colour, lut, measure, reserved)}, expected) << n;
  }
}

TEST(PerceptualSearch, EqualsTheDefinitionOnRandomColours) {
  std::mt19937 random(1);
  const Lut lut = random_lut(random, 256);
  PerceptualSearch search(lut);
  ColourMeasure measure(Goal::perceptual);
  for (std::uint64_t n = 0; n < test::cases(200'000); ++n) {
    const Rgb8 colour = any_colour(random);
    ASSERT_EQ(search(colour), perceptually_nearest(colour, lut, measure));
  }
}

TEST(PerceptualSearch, EqualsTheDefinitionOnTheWholeLattice) {
  std::mt19937 random(2);
  const Lut lut = random_lut(random, 256);
  PerceptualSearch search(lut);
  ColourMeasure measure(Goal::perceptual);
  for (int code = 0; code < 1 << 18; ++code) {
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(code >> shift & 63); };
    const Rgb8 colour = seen(DacCode{part(12), part(6), part(0)});
    ASSERT_EQ(search(colour), perceptually_nearest(colour, lut, measure));
  }
}

TEST(PerceptualSearch, EqualsTheDefinitionOnAnyLut) {
  std::mt19937 random(3);
  for (const std::size_t colours : {1, 2, 3, 20, 256})
    for (const unsigned levels : {1u, 2u, 5u, 20u, 64u})
      expect_same(random_lut(random, colours, {}, levels), random, 200);
}

TEST(PerceptualSearch, EqualsTheDefinitionOnGreys) {
  std::mt19937 random(4);
  std::vector<DacCode> greys;
  for (int i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(random() % 64);
    greys.push_back({level, level, level});
  }
  const Lut lut = make_lut(greys);
  expect_same(lut, random, 10000);
  PerceptualSearch search(lut);
  ColourMeasure measure(Goal::perceptual);
  for (int i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i);
    ASSERT_EQ(search({level, level, level}),
              perceptually_nearest({level, level, level}, lut, measure));
  }
}

TEST(PerceptualSearch, EqualsTheDefinitionForAnyDac) {
  std::mt19937 random(5);
  for (const DacBits& dac : {DacBits{{1, 1, 1}}, DacBits{{4, 4, 4}}, DacBits{{5, 6, 5}},
                             DacBits{{8, 8, 8}}, DacBits{{1, 8, 3}}})
    for (const std::size_t colours : {1, 8, 256})
      expect_same(random_lut(random, colours, dac), random, 300);
}

TEST(PerceptualSearch, LeavesReservedEntriesOut) {
  std::mt19937 random(6);
  const Lut lut = random_lut(random, 256, {}, 6);
  for (int n = 0; n < 20; ++n) {
    IndexSet reserved;
    const unsigned most = n < 10 ? 40 : 255;
    for (unsigned i = 0; i < most; ++i) reserved.set(random() % 256);
    if (n == 19) (reserved.set()).reset(77);
    expect_same(lut, random, 200, reserved);
  }
  ColourMeasure measure(Goal::perceptual);
  EXPECT_THROW(PerceptualSearch(lut, IndexSet{}.set()), std::invalid_argument);
  EXPECT_THROW(perceptually_nearest({}, lut, measure, IndexSet{}.set()), std::invalid_argument);
  EXPECT_THROW(map_perceptually(random_planes({2, 2}, 1), lut, IndexSet{}.set()),
               std::invalid_argument);
}

TEST(PerceptualSearch, AnExactColourMapsToItsFirstEntry) {
  std::mt19937 random(7);
  for (const unsigned levels : {4u, 64u}) {
    const Lut lut = random_lut(random, 256, {}, levels);
    PerceptualSearch search(lut);
    for (std::size_t i = 0; i < 256; ++i) {
      const auto first = std::find(lut.entry.begin(), lut.entry.end(), lut.entry[i]);
      ASSERT_EQ(search(lut.seen(i)), first - lut.entry.begin());
    }
  }
}

TEST(PerceptualSearch, TiesTakeTheLowestIndex) {
  // White, grey and black; what repeats them later is never taken.
  const Lut lut = make_lut(std::vector<DacCode>{
      {63, 63, 63}, {20, 20, 20}, {63, 63, 63}, {20, 20, 20}, {0, 0, 0}, {20, 20, 20}});
  for (int i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(i);
    const int index = PerceptualSearch(lut)({level, level, level});
    EXPECT_TRUE(index == 0 || index == 1 || index == 4) << i;
  }
}

TEST(PerceptualSearch, FarFromAllEntriesTakesTheOneThatLooksNearest) {
  // A yellow looks nearer to white than a brown that is almost black: 30 against 86.
  const Lut lut = make_lut(std::vector<DacCode>{{12, 5, 0}, {62, 53, 9}});
  EXPECT_EQ(PerceptualSearch(lut)({255, 255, 255}), 1);
}

TEST(PerceptualSearch, IsNeverFarFromTheLeastCiede2000) {
  std::mt19937 random(9);
  for (const std::size_t colours : {2, 8, 64}) {
    const Lut lut = random_lut(random, colours);
    PerceptualSearch search(lut);
    for (int n = 0; n < 500; ++n) {
      const Rgb8 colour = any_colour(random);
      const Lab lab = lab_of(colour);
      double least = 1000;
      for (std::size_t i = 0; i < colours; ++i)
        least = std::min(least, ciede2000(lab, lab_of(lut.seen(i))));
      ASSERT_LT(ciede2000(lab, lab_of(lut.seen(search(colour)))), 1.5 * least + 0.5) << colours;
    }
  }
}

TEST(MapPerceptually, EqualsTheDefinitionOnPictures) {
  std::mt19937 random(8);
  const Planes pictures[] = {random_planes({97, 61}, 1), bench::balls(), bench::grainy_balls()};
  for (const Planes& picture : pictures)
    for (const Lut& lut : {choose_lut(picture), random_lut(random, 256), random_lut(random, 3)}) {
      IndexSet reserved;
      for (int i = 0; i < 30; ++i) reserved.set(random() % 200);
      for (const IndexSet& left_out : {IndexSet{}, reserved}) {
        const auto indices = map_perceptually(picture, lut, left_out);
        ASSERT_EQ(indices.size(), picture.size.pixels());
        ColourMeasure measure(Goal::perceptual);
        const std::size_t step = picture.size.pixels() > 10000 ? 97 : 1;
        for (std::size_t i = 0; i < indices.size(); i += step)
          ASSERT_EQ(indices[i], perceptually_nearest(picture.at(i), lut, measure, left_out)) << i;
      }
    }
}

TEST(MapPerceptually, OfNoPixelsIsEmpty) {
  EXPECT_TRUE(map_perceptually(Planes(ImageSize{0, 0}), Lut{}).empty());
}

}  // namespace
}  // namespace sir::quant
