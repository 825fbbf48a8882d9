#include "viewer/viewport.h"

#include <gtest/gtest.h>

#include <random>

namespace sir::viewer {
namespace {

Viewport made(ImageSize window, ImageSize picture) {
  Viewport viewport;
  viewport.set_window(window);
  viewport.set_picture(picture);
  return viewport;
}

TEST(Viewport, FitsAndCentresAtFirst) {
  const Viewport viewport = made({2100, 1600}, {1024, 780});
  EXPECT_TRUE(viewport.fits_always());
  EXPECT_EQ(viewport.multiple(), 2);
  EXPECT_EQ(viewport.box(), (Letterbox{26, 20, 2048, 1560}));
  EXPECT_EQ(viewport.visible(), (Letterbox{0, 0, 1024, 780}));
}

TEST(Viewport, FitFollowsTheWindow) {
  Viewport viewport = made({2100, 1600}, {1024, 780});
  viewport.set_window({1024, 780});
  EXPECT_EQ(viewport.multiple(), 1);
  viewport.set_multiple(3);
  viewport.set_window({2100, 1600});
  EXPECT_EQ(viewport.multiple(), 3);
  viewport.fit();
  EXPECT_EQ(viewport.multiple(), 2);
}

TEST(Viewport, MultiplesStayWithinBounds) {
  Viewport viewport = made({100, 100}, {10, 10});
  viewport.set_multiple(0);
  EXPECT_EQ(viewport.multiple(), 1);
  viewport.set_multiple(1000);
  EXPECT_EQ(viewport.multiple(), kMaxMultiple);
}

TEST(Viewport, PixelsAreSquaresOfWholeWindowPixels) {
  Viewport viewport = made({100, 100}, {10, 10});
  viewport.set_multiple(3);
  const Letterbox box = viewport.box();
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const bool inside = x >= box.x && y >= box.y && x < box.x + 30 && y < box.y + 30;
      const auto pixel = viewport.pixel_at({x, y});
      ASSERT_EQ(pixel.has_value(), inside) << x << "," << y;
      if (!inside) continue;
      ASSERT_EQ(*pixel, (Place{(x - box.x) / 3, (y - box.y) / 3}));
    }
  EXPECT_FALSE(viewport.pixel_at({-1, 50}));
  EXPECT_FALSE(viewport.pixel_at({50, 100}));
}

TEST(Viewport, ALargePictureIsPannedToItsEdgesAndNoFarther) {
  Viewport viewport = made({100, 80}, {200, 40});
  EXPECT_EQ(viewport.box(), (Letterbox{-50, 20, 200, 40}));
  viewport.pan(30, 30);
  EXPECT_EQ(viewport.box(), (Letterbox{-20, 20, 200, 40}));  // down it fits: it stays centred
  viewport.pan(1000, 0);
  EXPECT_EQ(viewport.box().x, 0);
  viewport.pan(-1000, 0);
  EXPECT_EQ(viewport.box().x, -100);
  EXPECT_EQ(viewport.visible(), (Letterbox{100, 0, 100, 40}));
}

TEST(Viewport, PartlyVisiblePixelsCountAsVisible) {
  Viewport viewport = made({10, 10}, {10, 10});
  viewport.set_multiple(4);  // 40 pixels in 10: box at -15
  EXPECT_EQ(viewport.box().x, -15);
  EXPECT_EQ(viewport.visible(), (Letterbox{3, 3, 4, 4}));
}

// What is under the mouse stays there, as long as the picture's edges let it.
TEST(Viewport, ZoomsAboutTheAnchor) {
  std::mt19937 dice(7);
  for (int round = 0; round < 1000; ++round) {
    Viewport viewport = made({300, 200}, {1024, 780});
    viewport.set_multiple(1 + static_cast<int>(dice() % 4));
    viewport.pan(static_cast<int>(dice() % 400) - 200, static_cast<int>(dice() % 400) - 200);
    const Place anchor{static_cast<int>(dice() % 300), static_cast<int>(dice() % 200)};
    const auto before = viewport.pixel_at(anchor);
    ASSERT_TRUE(before);
    viewport.set_multiple(viewport.multiple() + 1 + static_cast<int>(dice() % 20), anchor);
    ASSERT_EQ(viewport.pixel_at(anchor), before);
  }
}

TEST(Viewport, RevealsAPixelAndMovesNoMoreThanItMust) {
  Viewport viewport = made({100, 100}, {300, 300});
  viewport.set_multiple(4);
  const Letterbox before = viewport.box();
  viewport.reveal({150, 150});
  EXPECT_EQ(viewport.box(), before);
  for (const Place pixel : {Place{0, 0}, Place{299, 299}, Place{20, 280}}) {
    viewport.reveal(pixel);
    const Letterbox box = viewport.box();
    EXPECT_GE(box.x + 4 * pixel.x, 0);
    EXPECT_LE(box.x + 4 * pixel.x + 4, 100);
    EXPECT_GE(box.y + 4 * pixel.y, 0);
    EXPECT_LE(box.y + 4 * pixel.y + 4, 100);
  }
}

TEST(Viewport, WithoutAWindowNothingIsVisible) {
  const Viewport viewport = made({0, 0}, {10, 10});
  EXPECT_EQ(viewport.visible().width, 0);
  EXPECT_FALSE(viewport.pixel_at({0, 0}));
}

TEST(Multiples, ZoomGoesUpAndDownTheSameSteps) {
  int multiple = 1, steps = 0;
  for (; multiple < kMaxMultiple; ++steps) {
    const int next = next_multiple(multiple);
    ASSERT_GT(next, multiple);
    ASSERT_EQ(previous_multiple(next), multiple);
    multiple = next;
  }
  EXPECT_LE(steps, 16);
  EXPECT_EQ(next_multiple(kMaxMultiple), kMaxMultiple);
  EXPECT_EQ(previous_multiple(1), 1);
  EXPECT_EQ(next_multiple(7), 8);  // as a fitted window may have it
  EXPECT_EQ(previous_multiple(7), 6);
}

}  // namespace
}  // namespace sir::viewer
