#include "eltek/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "eltek/bus.h"
#include "eltek/frame_timing.h"

namespace sir::eltek {
namespace {

TEST(FrameTiming, AgreesWithItself) {
  EXPECT_DOUBLE_EQ(kTiming.line_seconds() * kTiming.lines, kTiming.frame_seconds());
  EXPECT_NEAR(kTiming.refresh(), 60, 0.05);
  EXPECT_NEAR(kTiming.line_rate(), 48.95e3, 5);
  EXPECT_NEAR(kTiming.refresh() * kTiming.columns * kTiming.lines, kTiming.pixel_clock, 1e-3);
}

TEST(FrameTiming, TellsTheLineOfATime) {
  EXPECT_EQ(kTiming.line_at(0), 0);
  EXPECT_EQ(kTiming.line_at(kTiming.line_seconds() * 1.5), 1);
  EXPECT_EQ(kTiming.line_at(kTiming.frame_seconds() * 7.5), 408);
  for (int line = 0; line < kTiming.lines; ++line)
    ASSERT_EQ(kTiming.line_at(3 * kTiming.frame_seconds() + (line + 0.5) * kTiming.line_seconds()),
              line);
  EXPECT_LT(kTiming.line_at(std::nextafter(kTiming.frame_seconds(), 0.0)), kTiming.lines);
  EXPECT_THROW(kTiming.line_at(-1e-9), std::invalid_argument);
  EXPECT_THROW(kTiming.line_at(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(kTiming.line_at(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(RasterPosition, GoesOnThroughTheEndOfTheFrame) {
  RasterPosition beam;
  beam.advance_to(500);
  beam.advance_to(500);  // stands there
  EXPECT_EQ(beam.scanned(), 500);
  beam.advance_to(499);
  EXPECT_EQ(beam.line(), 499);
  EXPECT_EQ(beam.frames(), 1);
  beam.restart();
  EXPECT_EQ(beam.scanned(), 2 * 816);
  EXPECT_THROW(beam.advance_to(816), std::out_of_range);
}

class RasterTest : public testing::Test {
 protected:
  void background(int code) {
    bus.write(Port::lut_write, 0);
    for (int i = 0; i < 3; ++i) bus.write(Port::lut_data, static_cast<std::uint16_t>(code));
  }
  static Rgb8 grey(int code) {
    const auto byte = quant::seen_byte(code);
    return {byte, byte, byte};
  }
  Ma120 machine;
  Raster raster{machine};
  Bus bus{machine, &raster};
};

TEST_F(RasterTest, TheFrameIsWhatWasScannedAndWhatWillBe) {
  background(10);
  bus.wait(100);
  background(20);
  EXPECT_EQ(raster.tube().at(0, 99), grey(10));
  EXPECT_EQ(raster.tube().at(0, 100), Rgb8{});  // nothing came there yet
  EXPECT_EQ(raster.frame().at(0, 99), grey(10));
  EXPECT_EQ(raster.frame().at(0, 100), grey(20));
  bus.wait(50);  // of the next frame
  background(30);
  EXPECT_EQ(raster.tube().at(0, 49), grey(20));
  EXPECT_EQ(raster.tube().at(0, 99), grey(10));  // of the frame before
  EXPECT_EQ(raster.tube().at(0, 100), grey(20));
  EXPECT_EQ(raster.frame().at(0, 49), grey(20));
  EXPECT_EQ(raster.frame().at(0, 50), grey(30));
}

TEST_F(RasterTest, AFrameOfOnePaletteCanBeCaptured) {
  background(10);
  bus.write(Port::pixel, 200);
  bus.wait(100);
  bus.write(Port::column, 0);
  bus.write(Port::row, 0);
  bus.write(Port::pixel, 77);  // above the beam: too late for this frame
  bus.write(Port::row, 500);
  bus.write(Port::pixel, 66);
  bus.write(Port::pixel_mask, 0xF0);
  const auto capture = raster.capture();
  ASSERT_TRUE(capture);
  EXPECT_EQ(capture->indices[0], 200);
  EXPECT_EQ(capture->indices[500 * 1024 + 1], 66 & 0xF0);
  background(11);
  EXPECT_FALSE(raster.capture());
  background(10);
  EXPECT_TRUE(raster.capture());  // equal again
  bus.write(Port::blank, 1);
  EXPECT_FALSE(raster.capture());
  bus.wait(0);
  EXPECT_EQ(raster.capture(), machine.capture());  // all black
}

TEST_F(RasterTest, LinesThatNobodyWillSeeNeedNotBePainted) {
  background(10);
  raster.paint_from(3 * 816 + 5);
  bus.wait(700);
  bus.wait(0);
  EXPECT_EQ(raster.tube().at(0, 300), Rgb8{});
  bus.wait(700);
  bus.wait(0);
  bus.wait(700);
  bus.wait(0);
  background(20);
  bus.wait(8);
  EXPECT_EQ(raster.tube().at(0, 4), Rgb8{});
  EXPECT_EQ(raster.tube().at(0, 5), grey(20));
  EXPECT_EQ(raster.tube().at(0, 8), Rgb8{});
}

}  // namespace
}  // namespace sir::eltek
