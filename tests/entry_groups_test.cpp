// The pixels behind an entry.
#include "quant/entry_groups.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace sir::quant {
namespace {

TEST(EntryGroups, CountWeighAndSpread) {
  Planes image(ImageSize{5, 1});
  const Rgb8 colours[]{{10, 20, 30}, {10, 20, 30}, {16, 20, 30}, {200, 0, 0}, {13, 24, 30}};
  for (std::size_t i = 0; i < 5; ++i) image.set(i, colours[i]);
  const auto groups = entry_groups(image, std::vector<std::uint8_t>{7, 7, 7, 255, 7});
  EXPECT_EQ(groups[7].pixels, 4u);
  EXPECT_EQ(groups[7].colours, 3u);
  EXPECT_EQ(groups[7].mean, glm::dvec3(12.25, 21, 30));
  // ((2.25^2 + 1) * 2 + 3.75^2 + 1 + 0.75^2 + 9) / 4 = (12.125 + 15.0625 + 9.5625) / 4
  EXPECT_NEAR(groups[7].spread * groups[7].spread, 9.1875, 1e-9);
  EXPECT_EQ(groups[255].pixels, 1u);
  EXPECT_EQ(groups[255].spread, 0);
  EXPECT_EQ(groups[0].pixels, 0u);
  EXPECT_THROW(entry_groups(image, std::vector<std::uint8_t>(4)), std::invalid_argument);
}

TEST(EntryGroups, TheNearestOtherIsOfAnotherColour) {
  // Seen as 170, 85, 0 and 170 of red; the rest repeat the last.
  const Lut lut = make_lut(std::vector<DacCode>{{42, 0, 0}, {21, 0, 0}, {0, 0, 0}, {42, 0, 0}});
  EXPECT_EQ(nearest_other(lut, 1), 0);  // as near as 2; the lower index
  EXPECT_EQ(nearest_other(lut, 0), 1);  // not 3, which is of the same colour
  EXPECT_EQ(nearest_other(lut, 2), 1);
  EXPECT_EQ(nearest_other(lut, 200), 1);
  EXPECT_EQ(nearest_other(make_lut(std::vector<DacCode>{{1, 2, 3}}), 0), std::nullopt);
}

}  // namespace
}  // namespace sir::quant
