#include "eltek/dac.h"

#include <gtest/gtest.h>

namespace sir::eltek {
namespace {

// floor(255 e / 63 + 1/2) as a fraction: the n for which
// 126 n <= 510 e + 63 < 126 (n + 1).
TEST(Dac, AllCodesAreRoundedExactly) {
  for (int e = 0; e < 64; ++e) {
    const int level = dac_level(static_cast<std::uint8_t>(e));
    EXPECT_LE(126 * level, 510 * e + 63) << e;
    EXPECT_GT(126 * (level + 1), 510 * e + 63) << e;
  }
}

TEST(Dac, KnownLevels) {
  EXPECT_EQ(dac_level(0), 0);
  EXPECT_EQ(dac_level(1), 4);
  EXPECT_EQ(dac_level(21), 85);
  EXPECT_EQ(dac_level(32), 130);
  EXPECT_EQ(dac_level(63), 255);
}

// Repeating the high bits below, the usual way, is another curve.
TEST(Dac, IsNotBitReplication) {
  int different = 0;
  for (int e = 0; e < 64; ++e)
    different += dac_level(static_cast<std::uint8_t>(e)) != (e << 2 | e >> 4);
  EXPECT_EQ(different, 10);
}

TEST(Dac, OnlySixBitsAreWired) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_EQ(dac_level(static_cast<std::uint8_t>(byte)), dac_level(byte & 63));
}

TEST(Dac, OfAnyBitsRoundsExactlyAndWiresTheLowBits) {
  for (int bits = 1; bits <= 8; ++bits) {
    const int most = (1 << bits) - 1;
    for (int code = 0; code < 256; ++code) {
      const int level = dac_level(static_cast<std::uint8_t>(code), bits), e = code & most;
      EXPECT_LE(2 * most * level, 510 * e + most) << bits << " bits, code " << code;
      EXPECT_GT(2 * most * (level + 1), 510 * e + most) << bits << " bits, code " << code;
    }
  }
  EXPECT_EQ(dac_colour({31, 63, 31}, {{5, 6, 5}}), (Rgb8{255, 255, 255}));
  EXPECT_EQ(dac_colour({12, 12, 11}, {{5, 6, 5}}), (Rgb8{99, 49, 90}));
}

TEST(Dac, OneConverterPerPrimary) { EXPECT_EQ(dac_colour({0, 32, 63}), (Rgb8{0, 130, 255})); }

}  // namespace
}  // namespace sir::eltek
