// A DAC's bits from words and back.
#include "quant/dac_parse.h"

#include <gtest/gtest.h>

namespace sir::quant {
namespace {

TEST(ParseBits, ReadsThreeNumbersOrOneForAll) {
  for (int r = 1; r <= 8; ++r)
    for (int g = 1; g <= 8; ++g)
      for (int b = 1; b <= 8; ++b) {
        const DacBits wanted{{r, g, b}};
        DacBits read;
        ASSERT_TRUE(parse_bits(bits_text(wanted), read)) << bits_text(wanted);
        EXPECT_EQ(read, wanted);
      }
  for (int bits = 1; bits <= 8; ++bits) {
    DacBits read;
    ASSERT_TRUE(parse_bits(std::to_string(bits), read));
    EXPECT_EQ(read, (DacBits{{bits, bits, bits}}));
  }
  EXPECT_EQ(bits_text({{5, 6, 5}}), "5,6,5");
}

TEST(ParseBits, LeavesTheDacAloneWhereTheTextIsWrong) {
  for (const char* text :
       {"",        ",",      "5,",  "5,6",     "5,6,",  ",5,6",        "5,6,5,", "5,6,5,4", "5 6 5",
        "5, 6, 5", " 6",     "6 ",  "0",       "9",     "-1",          "+6",     "0,6,6",   "6,9,6",
        "6,6,0",   "6,6,-1", "6.0", "6,6,6.5", "5x6x5", "99999999999", "six",    "6;6;6"}) {
    DacBits dac{{3, 4, 5}};
    EXPECT_FALSE(parse_bits(text, dac)) << text;
    EXPECT_EQ(dac, (DacBits{{3, 4, 5}})) << text;
  }
}

}  // namespace
}  // namespace sir::quant
