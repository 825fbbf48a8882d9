// The clock's report says what the figures say, for and against.
#include "cli/clock_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "tests/random_planes.h"

namespace sir::cli {
namespace {

using quant::Space;
using ::testing::HasSubstr;
using ::testing::Not;

/// Three images; times of 0.1 s a pixel and 0.2 s a cell, except for `late` seconds that
/// CALICE in RGB took longer.
ClockReading reading(const char* split, bool shrink, double late) {
  ClockReading made{split, shrink, {}};
  const auto add = [&](const char* image, Space space, std::uint64_t cells, double extra) {
    const std::uint64_t conversions = space == Space::hsv ? 100 : 0;
    made.samples.push_back({image,
                            space,
                            {100, conversions, cells},
                            cells * cells % 101,
                            10 + 0.2 * static_cast<double>(cells) + extra});
  };
  add("CALICE", Space::rgb, 30, late);
  add("CALICE", Space::hsv, 40, 0);
  add("LCG", Space::rgb, 300, 0);
  add("LCG", Space::hsv, 50, 0);
  add("WHITTED", Space::rgb, 200, 0);
  add("WHITTED", Space::hsv, 60, 0);
  return made;
}

TEST(ClockReport, SaysThatAnExplanationIsPossible) {
  const std::vector<ClockReading> readings{reading("pixels", true, 0), reading("pixels", false, 0)};
  const std::string text = clock_text(readings);
  EXPECT_THAT(text, HasSubstr("that the explanation is possible"));
  EXPECT_THAT(text, HasSubstr("three constants were fitted to\n6 numbers"));
  EXPECT_THAT(text, HasSubstr("RGB is the faster in: CALICE; the model says: CALICE."));
  EXPECT_THAT(text, HasSubstr("RGB: 3 of 3 by cells visited"));
  EXPECT_THAT(text, HasSubstr("pixels, not shrunk"));
  EXPECT_THAT(text, HasSubstr(" 1.000 "));  // R^2
  EXPECT_THAT(text, HasSubstr("their own R^2 is 1.00"));
}

TEST(ClockReport, SaysThatAnExplanationFails) {
  const std::vector<ClockReading> readings{reading("breadth", true, 200)};
  const std::string text = clock_text(readings);
  EXPECT_THAT(text, HasSubstr("nothing in favour"));
  EXPECT_THAT(text, Not(HasSubstr("is possible")));
  EXPECT_THAT(text, HasSubstr("RGB is the faster in: none; the model says: "));
  EXPECT_THAT(text, HasSubstr("The largest residual is CALICE's in RGB"));
  EXPECT_THAT(text, HasSubstr("RGB: 0 of 3 by cells visited"));
}

TEST(ClockReport, TheBestOfTheShrunkReadingsLeads) {
  auto worse = reading("pixels", true, 0);
  worse.samples[2].work.cells_visited = 200;
  const std::vector<ClockReading> readings{worse, reading("longest", true, 0),
                                           reading("breadth", false, 0)};
  EXPECT_THAT(clock_text(readings), HasSubstr("`longest` fits best"));
  EXPECT_THROW(clock_text(std::span(readings).last(1)), std::invalid_argument);
}

TEST(ClockReport, WalksEveryImageInSixReadings) {
  const std::vector<ClockImage> images{{"a", test::random_planes({20, 10}, 1), 3, 4},
                                       {"b", test::random_planes({30, 20}, 2), 5, 6}};
  const auto readings = clock_readings(images);
  ASSERT_EQ(readings.size(), 6u);
  for (const ClockReading& one : readings) {
    ASSERT_EQ(one.samples.size(), 4u);
    EXPECT_EQ(one.samples[0].work.conversions, 0u);
    EXPECT_EQ(one.samples[1].work.conversions, 200u);
    EXPECT_EQ(one.samples[3].work.pixels_read, 600u);
    EXPECT_EQ(one.samples[2].colours, quant::occupied_cells(images[1].planes).rgb);
    EXPECT_EQ(one.samples[3].measured_seconds, 6);
    EXPECT_GE(one.samples[2].work.cells_visited, 32768u);
  }
  EXPECT_TRUE(readings[0].shrink);
  EXPECT_FALSE(readings[5].shrink);
}

}  // namespace
}  // namespace sir::cli
