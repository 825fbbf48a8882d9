#include "viewer/pixel_density.h"

#include <gtest/gtest.h>

namespace sir::viewer {
namespace {

// What desktops offer: whole densities, quarters, and a window whose pixels were rounded.
constexpr PixelDensity kDensities[] = {{1, 1},       {1024, 1024}, {1024, 2048}, {1024, 1280},
                                       {1024, 1536}, {683, 1024},  {1365, 2389}, {3, 4}};

TEST(PixelDensity, AWindowOfSoManyUnitsHoldsThePixelsAndIsNoLargerThanItMust) {
  for (const PixelDensity density : kDensities)
    for (int pixels = 1; pixels < 3000; ++pixels) {
      const std::int64_t units = density.units_of(pixels);
      ASSERT_GE(units * density.pixels, std::int64_t{pixels} * density.units);
      ASSERT_LT((units - 1) * density.pixels, std::int64_t{pixels} * density.units);
    }
  // The MA120's screen at 1.5: 682 units would cut its last column off.
  EXPECT_EQ((PixelDensity{1024, 1536}.units_of(1024)), 683);
}

TEST(PixelDensity, APanelTakesThePixelsThatItsUnitsTouch) {
  for (const PixelDensity density : kDensities)
    for (int units = 0; units < 3000; ++units) {
      const std::int64_t pixels = density.pixels_of(units);
      ASSERT_GE(pixels * density.units, std::int64_t{units} * density.pixels);
      ASSERT_LT((pixels - 1) * density.units, std::int64_t{units} * density.pixels);
    }
  EXPECT_EQ((PixelDensity{1024, 1280}.pixels_of(340)), 425);  // not 340, as at a scale of 1
  EXPECT_EQ((PixelDensity{1024, 1536}.pixels_of(340)), 510);  // nor 680, as at a scale of 2
}

TEST(PixelDensity, TheMouseIsOverThePixelOfItsUnit) {
  EXPECT_EQ((PixelDensity{1024, 2048}.pixel_at(10)), 20);
  EXPECT_EQ((PixelDensity{1024, 1536}.pixel_at(3)), 4);
  EXPECT_EQ((PixelDensity{1024, 1536}.pixel_at(-1)), -2);  // left of the window is not its edge
}

TEST(PixelDensity, LettersGrowWithIt) {
  EXPECT_EQ((PixelDensity{1024, 1024}.scale()), 1);
  EXPECT_EQ((PixelDensity{1024, 1280}.scale()), 1);
  EXPECT_EQ((PixelDensity{1024, 1536}.scale()), 2);
  EXPECT_EQ((PixelDensity{1024, 2048}.scale()), 2);
  EXPECT_EQ((PixelDensity{1024, 900}.scale()), 1);
}

}  // namespace
}  // namespace sir::viewer
