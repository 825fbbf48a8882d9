#include "viewer/letterbox.h"

#include <gtest/gtest.h>

namespace sir::viewer {
namespace {

TEST(Letterbox, TakesTheLargestWholeMultiple) {
  EXPECT_EQ(largest_multiple({1024, 780}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({2047, 1560}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({2048, 1560}, {1024, 780}), 2);
  EXPECT_EQ(largest_multiple({300, 300}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({5000, 5000}, {2, 2}), kMaxMultiple);
}

TEST(Letterbox, CentresAndMayReachBeyondTheWindow) {
  EXPECT_EQ(centre({2100, 1600}, {1024, 780}, 2), (Letterbox{26, 20, 2048, 1560}));
  EXPECT_EQ(centre({1024, 780}, {1024, 780}, 2), (Letterbox{-512, -390, 2048, 1560}));
}

}  // namespace
}  // namespace sir::viewer
