// Counts and orders of a LUT's entries.
#include "viewer/lut_usage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "quant/ciede2000.h"
#include "quant/color_space.h"
#include "quant/nearest.h"
#include "tests/random_planes.h"

namespace sir::viewer {
namespace {

/// 200 entries out of noise, the rest repeating the last.
quant::Lut noisy_lut() {
  std::vector<quant::DacCode> codes;
  const Planes noise = test::random_planes({200, 1}, 9);
  for (std::size_t i = 0; i < 200; ++i) {
    const Rgb8 c = noise.at(i);
    const auto code = [&](std::uint8_t byte) { return static_cast<std::uint8_t>(byte / 4); };
    codes.push_back({code(c.r), code(c.g), i % 4 == 0 ? code(c.r) : code(c.b)});
    if (i % 8 == 0) codes.back() = {code(c.r), code(c.r), code(c.r)};
  }
  return quant::make_lut(codes);
}

TEST(LutUsage, CountsPixelsUnusedAndRepeated) {
  const quant::Lut lut =
      quant::make_lut(std::vector<quant::DacCode>{{1, 2, 3}, {5, 5, 5}, {1, 2, 3}, {9, 9, 9}});
  const LutUsage usage = lut_usage(lut, std::vector<std::uint8_t>{1, 1, 3, 0, 1});
  EXPECT_EQ(usage.pixels[0], 1u);
  EXPECT_EQ(usage.pixels[1], 3u);
  EXPECT_EQ(usage.pixels[2], 0u);
  EXPECT_EQ(usage.pixels[3], 1u);
  EXPECT_EQ(usage.unused, 253u);
  EXPECT_EQ(usage.repeated, 253u);  // 2, and 4 to 255
}

TEST(EntryOrder, IsAStablePermutationByItsKey) {
  const quant::Lut lut = noisy_lut();
  const auto indices = quant::map_to_lut(test::random_planes({50, 40}, 3), lut);
  const LutUsage usage = lut_usage(lut, indices);
  const auto hsv = [&](std::uint8_t i) { return quant::hsv_of(lut.seen(i)); };
  const auto before = [&](EntryOrder order, std::uint8_t a, std::uint8_t b) {
    switch (order) {
      case EntryOrder::index: return a < b;
      case EntryOrder::pixels: return usage.pixels[a] > usage.pixels[b];
      case EntryOrder::hue: {
        if ((hsv(a).s > 0) != (hsv(b).s > 0)) return hsv(b).s > 0;
        if (hsv(a).h != hsv(b).h) return hsv(a).h < hsv(b).h;
        return hsv(a).v < hsv(b).v;
      }
      case EntryOrder::lightness:
        return quant::lab_of(lut.seen(a)).l < quant::lab_of(lut.seen(b)).l;
    }
    return false;
  };
  for (const EntryOrder order :
       {EntryOrder::index, EntryOrder::pixels, EntryOrder::hue, EntryOrder::lightness}) {
    const auto found = entry_order(lut, usage, order);
    auto sorted = found;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(sorted[i], i);
    for (std::size_t i = 1; i < 256; ++i) {
      EXPECT_FALSE(before(order, found[i], found[i - 1]));
      if (!before(order, found[i - 1], found[i])) {
        EXPECT_LT(found[i - 1], found[i]);
      }
    }
  }
}

TEST(PrimaryHistogram, CountsEveryByteInItsBin) {
  const Planes picture = test::random_planes({64, 33}, 6);
  const auto fine = primary_histogram(picture, 256), coarse = primary_histogram(picture, 64);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t byte = 0; byte < 256; ++byte)
      EXPECT_EQ(fine[c][byte], static_cast<std::uint64_t>(std::count(
                                   picture.channel[c].begin(), picture.channel[c].end(), byte)));
    for (std::size_t bin = 0; bin < 64; ++bin)
      EXPECT_EQ(coarse[c][bin],
                std::accumulate(&fine[c][4 * bin], &fine[c][4 * bin] + 4, std::uint64_t{0}));
  }
  EXPECT_THROW(primary_histogram(picture, 0), std::invalid_argument);
  EXPECT_THROW(primary_histogram(picture, 100), std::invalid_argument);
}

}  // namespace
}  // namespace sir::viewer
