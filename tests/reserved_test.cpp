// Reserved entries: no pixel takes them, and all others are searched as ever.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "quant/index_set.h"
#include "quant/inverse_map.h"
#include "quant/nearest.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

IndexSet indices(std::string_view text) {
  IndexSet set;
  EXPECT_TRUE(parse_indices(text, set)) << text;
  return set;
}

Planes pixel(Rgb8 colour) {
  Planes image(ImageSize{1, 1});
  image.set(0, colour);
  return image;
}

/// The definition, from what is asked: least distance, lowest index, none reserved.
std::vector<std::uint8_t> by_definition(const Planes& image, const Lut& lut,
                                        const IndexSet& reserved) {
  std::vector<std::uint8_t> found;
  for (std::size_t p = 0; p < image.size.pixels(); ++p) {
    const Rgb8 c = image.at(p);
    int best = -1, least = 0;
    for (int i = 255; i >= 0; --i) {
      const Rgb8 e = lut.seen(static_cast<std::size_t>(i));
      const int d =
          (e.r - c.r) * (e.r - c.r) + (e.g - c.g) * (e.g - c.g) + (e.b - c.b) * (e.b - c.b);
      if (reserved[static_cast<std::size_t>(i)] || (best >= 0 && d > least)) continue;
      best = i;
      least = d;
    }
    found.push_back(static_cast<std::uint8_t>(best));
  }
  return found;
}

double distance(Rgb8 a, Rgb8 b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

/// Entries of `levels` codes a primary: few make many equal entries.
Lut random_lut(std::mt19937& random, std::size_t colours, unsigned levels) {
  std::vector<DacCode> codes(colours);
  for (DacCode& code : codes)
    for (auto& level : code) level = static_cast<std::uint8_t>(random() % levels * (63 / levels));
  return make_lut(codes);
}

/// The colours of the entries themselves, and their neighbours.
Planes entries_and_neighbours(const Lut& lut) {
  Planes image(ImageSize{256, 2});
  for (std::size_t i = 0; i < 256; ++i) {
    const Rgb8 exact = lut.seen(i);
    image.set(i, exact);
    image.set(256 + i, {static_cast<std::uint8_t>(exact.r ^ 1), exact.g,
                        static_cast<std::uint8_t>(exact.b ^ 2)});
  }
  return image;
}

TEST(ParseIndices, ReadsIndicesAndRanges) {
  EXPECT_EQ(indices("0-15,255").count(), 17u);
  for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(indices("0-15,255")[i], i < 16 || i == 255) << i;
  EXPECT_EQ(indices("7"), IndexSet().set(7));
  EXPECT_EQ(indices("7-7,007"), IndexSet().set(7));
  EXPECT_EQ(indices("9,3-5,4-6"), IndexSet().set(3).set(4).set(5).set(6).set(9));
  EXPECT_TRUE(indices("0-255").all());
}

TEST(ParseIndices, LeavesTheSetAloneWhereTheTextIsWrong) {
  for (const char* text : {"",
                           ",",
                           "1,",
                           ",1",
                           "1,,2",
                           "256",
                           "-1",
                           "1-",
                           "-",
                           "1-256",
                           "5-3",
                           "1-2-3",
                           "1 ",
                           " 1",
                           "1, 2",
                           "1;2",
                           "a",
                           "1.5",
                           "0x10",
                           "+1",
                           "99999999999999999999",
                           "1-99999999999999999999"}) {
    IndexSet set = IndexSet().set(42);
    EXPECT_FALSE(parse_indices(text, set)) << text;
    EXPECT_EQ(set, IndexSet().set(42)) << text;
  }
}

TEST(Reserved, AnExactColourGoesToAnEqualEntryThatStandsLater) {
  std::vector<DacCode> codes(256, DacCode{63, 0, 0});
  codes[3] = codes[90] = {10, 20, 30};
  codes[4] = {10, 20, 31};
  const Lut lut = make_lut(codes);
  const Rgb8 exact = lut.seen(3);
  const auto all_ways = [&](const IndexSet& reserved) {
    const std::uint8_t entry = nearest_entry(exact, lut, reserved);
    EXPECT_EQ(NearestSearch(lut, reserved)(exact), entry);
    EXPECT_EQ(map_to_lut(pixel(exact), lut, Mapping::exact, reserved)[0], entry);
    EXPECT_EQ(map_exhaustively(pixel(exact), lut, reserved)[0], entry);
    return entry;
  };
  EXPECT_EQ(all_ways({}), 3);
  EXPECT_EQ(all_ways(indices("3")), 90);
  EXPECT_EQ(all_ways(indices("90")), 3);
  EXPECT_EQ(all_ways(indices("3,90")), 4);
  EXPECT_EQ(all_ways(indices("0-199")), 200);
}

TEST(Reserved, TheRepetitionsOfTheLastColourAreEntriesToo) {
  const Lut lut = make_lut(std::vector<DacCode>{{0, 0, 0}, {63, 63, 63}});
  for (const Mapping mapping : {Mapping::exact, Mapping::approximate}) {
    EXPECT_EQ(map_to_lut(pixel({255, 255, 255}), lut, mapping, indices("1"))[0], 2);
    EXPECT_EQ(map_to_lut(pixel({255, 255, 255}), lut, mapping, indices("1-254"))[0], 255);
    EXPECT_EQ(map_to_lut(pixel({255, 255, 255}), lut, mapping, indices("1-255"))[0], 0);
    EXPECT_EQ(map_to_lut(pixel({0, 0, 0}), lut, mapping, indices("0"))[0], 1);
  }
}

TEST(Reserved, TheFastSearchEqualsTheDefinition) {
  std::mt19937 random(31);
  const Planes noise = test::random_planes({64, 48}, 32);
  for (const std::size_t colours : {1, 2, 20, 256})
    for (const unsigned levels : {2u, 5u, 63u})
      for (const int share : {1, 8, 128, 254, 255}) {
        const Lut lut = random_lut(random, colours, levels);
        IndexSet reserved;
        for (int i = 0; i < share; ++i) reserved.set(random() % 256);
        if (share == 255) reserved.set().reset(random() % 256);
        for (const Planes& image : {noise, entries_and_neighbours(lut)}) {
          const auto fast = map_to_lut(image, lut, Mapping::exact, reserved);
          ASSERT_EQ(fast, by_definition(image, lut, reserved));
          ASSERT_EQ(fast, map_exhaustively(image, lut, reserved));
          for (const std::uint8_t index : fast) ASSERT_FALSE(reserved[index]);
          // The approximate one errs by a cell's diagonal at most, among the same entries.
          const auto near = map_to_lut(image, lut, Mapping::approximate, reserved);
          for (std::size_t i = 0; i < near.size(); ++i) {
            ASSERT_FALSE(reserved[near[i]]);
            ASSERT_LE(distance(image.at(i), lut.seen(near[i])),
                      distance(image.at(i), lut.seen(fast[i])) + InverseMap::kWorst);
          }
        }
      }
}

TEST(Reserved, NoneIsTheSearchAsItWas) {
  std::mt19937 random(33);
  const Lut lut = random_lut(random, 256, 63);
  const Planes noise = test::random_planes({64, 48}, 34);
  for (const Mapping mapping : {Mapping::exact, Mapping::approximate})
    EXPECT_EQ(map_to_lut(noise, lut, mapping, {}), map_to_lut(noise, lut, mapping));
}

TEST(Reserved, AllIsRefused) {
  const Lut lut = make_lut(std::vector<DacCode>{{1, 2, 3}});
  const IndexSet all = indices("0-255");
  const Planes image = pixel({1, 2, 3});
  EXPECT_THROW(nearest_entry({1, 2, 3}, lut, all), std::invalid_argument);
  EXPECT_THROW(NearestSearch(lut, all), std::invalid_argument);
  EXPECT_THROW(InverseMap(lut, all), std::invalid_argument);
  EXPECT_THROW(map_exhaustively(image, lut, all), std::invalid_argument);
  EXPECT_THROW(map_to_lut(image, lut, Mapping::exact, all), std::invalid_argument);
  EXPECT_THROW(map_to_lut(image, lut, Mapping::approximate, all), std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
