// The code nearest to a byte, against its definition, for every byte and every DAC.
#include "quant/lattice.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

namespace sir::quant {
namespace {

/// The definition: the least |seen - byte|, the lower code on ties.
int by_definition(int byte, int bits) {
  int best = 0;
  for (int code = 1; code < 1 << bits; ++code)
    if (std::abs(seen_byte(code, bits) - byte) < std::abs(seen_byte(best, bits) - byte))
      best = code;
  return best;
}

TEST(Lattice, NearestIsTheDefinitionForEveryByteAndNumberOfBits) {
  for (int bits = 1; bits <= 8; ++bits)
    for (int other = 1; other <= 8; ++other) {
      const Lattice lattice(DacBits{{bits, other, 9 - bits}});
      for (int byte = 0; byte < 256; ++byte) {
        const auto level = static_cast<std::uint8_t>(byte);
        const DacCode code = lattice.nearest({level, level, level});
        ASSERT_EQ(code[0], by_definition(byte, bits)) << byte << " in " << bits << " bits";
        ASSERT_EQ(code[1], by_definition(byte, other)) << byte << " in " << other << " bits";
        ASSERT_EQ(code[2], by_definition(byte, 9 - bits)) << byte << " in " << 9 - bits << " bits";
      }
    }
}

TEST(Lattice, APointIsNearestToItself) {
  for (int bits = 1; bits <= 8; ++bits) {
    const DacBits dac{{bits, bits, bits}};
    for (int e = 0; e < 1 << bits; ++e) {
      const auto level = static_cast<std::uint8_t>(e);
      const DacCode code{level, 0, static_cast<std::uint8_t>((1 << bits) - 1 - e)};
      ASSERT_EQ(nearest_code(Lattice(dac).seen(code), dac), code);
    }
  }
}

TEST(Lattice, KnownBytes) {
  // 6 bits: codes 0, 1, 2 are seen as 0, 4, 8. 2 lies half way between the first two.
  EXPECT_EQ(nearest_code({2, 3, 6}, DacBits{}), (DacCode{0, 1, 1}));
  EXPECT_EQ(nearest_code({255, 254, 0}, DacBits{}), (DacCode{63, 63, 0}));
  // 1 bit: 127 is nearer to black, 128 to white. 8 bits: every byte is a code.
  EXPECT_EQ(nearest_code({127, 128, 77}, DacBits{{1, 1, 8}}), (DacCode{0, 1, 77}));
  // 4 bits: multiples of 17, never half way.
  EXPECT_EQ(nearest_code({8, 9, 246}, DacBits{{4, 4, 4}}), (DacCode{0, 1, 14}));
}

TEST(Lattice, RefusesImpossibleBits) {
  EXPECT_THROW(Lattice(DacBits{{6, 0, 6}}), std::invalid_argument);
  EXPECT_THROW(Lattice(DacBits{{9, 6, 6}}), std::invalid_argument);
  EXPECT_THROW(nearest_code({}, DacBits{{6, 6, -1}}), std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
