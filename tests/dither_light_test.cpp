// Bytes to linear light and back, against the curve itself.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "quant/linear_light.h"

namespace sir::quant {
namespace {

const LinearLight& table() { return LinearLight::table(); }

TEST(LinearLight, IsTheCurveOfSrgb) {
  EXPECT_EQ(light_of_coded(0), 0);
  EXPECT_EQ(light_of_coded(1), 1);
  EXPECT_NEAR(light_of_coded(0.5), 0.214041140482233, 1e-15);  // IEC 61966-2-1
  EXPECT_NEAR(light_of_coded(0.04045), 0.04045 / 12.92, 1e-15);
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_EQ(table().of(static_cast<std::uint8_t>(byte)), light_of_coded(byte / 255.0));
  EXPECT_EQ(table().of(Rgb8{1, 2, 3}), (Light{table().of(1), table().of(2), table().of(3)}));
}

TEST(LinearLight, GivesEveryByteBack) {
  for (int byte = 0; byte < 256; ++byte) {
    const auto level = static_cast<std::uint8_t>(byte);
    EXPECT_EQ(table().byte(table().of(level)), level);
  }
  EXPECT_EQ(table().colour(table().of(Rgb8{7, 130, 255})), (Rgb8{7, 130, 255}));
}

// The definition: the largest byte whose range has begun.
int by_definition(double light) {
  int byte = 255;
  while (byte > 0 && light_of_coded((byte - 0.5) / 255) > light) --byte;
  return byte;
}

TEST(LinearLight, RoundsByTheDefinition) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-0.1, 1.1), dark(0, 0.01);
  for (int n = 0; n < 100000; ++n) {
    const double light = n % 2 ? anywhere(random) : dark(random);
    ASSERT_EQ(table().byte(light), by_definition(light)) << light;
  }
  for (int bin = 0; bin <= 4096; ++bin)
    ASSERT_EQ(table().byte(bin / 4096.0), by_definition(bin / 4096.0)) << bin;
}

TEST(LinearLight, ChangesTheByteExactlyAtItsThreshold) {
  for (int byte = 1; byte < 256; ++byte) {
    const double begin = light_of_coded((byte - 0.5) / 255);
    EXPECT_EQ(table().byte(begin), byte);
    EXPECT_EQ(table().byte(std::nextafter(begin, 0)), byte - 1);
  }
}

TEST(LinearLight, TakesTheEndsBeyondThem) {
  EXPECT_EQ(table().byte(-5), 0);
  EXPECT_EQ(table().byte(5), 255);
}

}  // namespace
}  // namespace sir::quant
