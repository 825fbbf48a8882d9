// Register sequences such as programs for boards of the time used.
#include "eltek/bus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "eltek/dac.h"
#include "eltek/display_driver.h"
#include "eltek/transfer.h"

namespace sir::eltek {
namespace {

using quant::DacCode;

class BusTest : public testing::Test {
 protected:
  void send(int first, std::initializer_list<int> codes) {
    bus.write(Port::lut_write, static_cast<std::uint16_t>(first));
    for (const int code : codes) bus.write(Port::lut_data, static_cast<std::uint16_t>(code));
  }
  void at(int column, int row) {
    bus.write(Port::column, static_cast<std::uint16_t>(column));
    bus.write(Port::row, static_cast<std::uint16_t>(row));
  }
  void pixels(std::initializer_list<std::uint8_t> indices) {
    bus.write_pixels(std::vector<std::uint8_t>(indices));
  }
  std::vector<int> read_pixels(std::size_t count) {
    std::vector<std::uint8_t> indices(count);
    bus.read_pixels(indices);
    return {indices.begin(), indices.end()};
  }
  DacCode entry(int index) const {
    return machine.lut_ports.look_up(static_cast<std::uint8_t>(index));
  }

  Ma120 machine;
  Raster raster{machine};
  Bus bus{machine, &raster};
};

using Ints = std::vector<int>;

TEST_F(BusTest, LutEntriesGoThroughThePorts) {
  send(254, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_EQ(entry(254), (DacCode{1, 2, 3}));
  EXPECT_EQ(entry(0), (DacCode{7, 8, 9}));
  EXPECT_EQ(bus.read(Port::lut_write), 1);
  send(254, {60, 61});
  EXPECT_EQ(bus.read(Port::lut_read), 254);  // the half entry waits
  EXPECT_EQ(entry(254), (DacCode{1, 2, 3}));
}

TEST_F(BusTest, AFadeReadsChangesAndWritesBack) {
  send(7, {63, 40, 2, 10, 20, 30});
  for (int step = 0; step < 70; ++step)
    for (const std::uint16_t index : {std::uint16_t{7}, std::uint16_t{8}}) {
      bus.write(Port::lut_read, index);
      int codes[3];
      for (int& code : codes) code = bus.read(Port::lut_data);
      bus.write(Port::lut_write, index);
      for (const int code : codes)
        bus.write(Port::lut_data, static_cast<std::uint16_t>(std::max(code - 1, 0)));
      if (step == 9 && index == 7) {
        EXPECT_EQ(entry(7), (DacCode{53, 30, 0}));
      }
    }
  EXPECT_EQ(entry(7), DacCode{});
  EXPECT_EQ(entry(8), DacCode{});
}

TEST_F(BusTest, OnlyTheBitsOfARegisterAreWired) {
  bus.write(Port::lut_write, 0x1FE);
  EXPECT_EQ(bus.read(Port::lut_write), 0xFE);
  bus.write(Port::column, 1024 + 5);
  bus.write(Port::row, 0xFFFF);
  bus.write(Port::pixel_mask, 0x10F);
  bus.write(Port::plane_mask, 0x2F0);
  bus.write(Port::blank, 2);
  EXPECT_EQ(bus.read(Port::column), 5);
  EXPECT_EQ(bus.read(Port::row), 1023);
  EXPECT_EQ(bus.read(Port::pixel_mask), 0x0F);
  EXPECT_EQ(bus.read(Port::plane_mask), 0xF0);
  EXPECT_EQ(bus.read(Port::blank), 0);
}

TEST_F(BusTest, PixelsMoveOnAlongTheRowAndToTheNext) {
  at(1022, 3);
  pixels({1, 2, 3, 4});
  EXPECT_EQ(machine.frame_buffer.read(1022, 3), 1);
  EXPECT_EQ(machine.frame_buffer.read(1023, 3), 2);
  EXPECT_EQ(machine.frame_buffer.read(0, 4), 3);
  EXPECT_EQ(bus.read(Port::column), 2);
  EXPECT_EQ(bus.read(Port::row), 4);
  at(1022, 3);
  EXPECT_EQ(read_pixels(4), (Ints{1, 2, 3, 4}));
}

TEST_F(BusTest, BehindTheLastPixelComesTheFirst) {
  at(1023, 779);
  pixels({5, 6});
  EXPECT_EQ(machine.frame_buffer.read(1023, 779), 5);
  EXPECT_EQ(machine.frame_buffer.read(0, 0), 6);
  at(1023, 779);
  bus.fill_pixels(9, 3);
  EXPECT_EQ(machine.frame_buffer.read(1023, 779), 9);
  EXPECT_EQ(machine.frame_buffer.read(1, 0), 9);
  EXPECT_EQ(bus.read(Port::column), 2);
}

TEST_F(BusTest, BelowTheScreenThereIsNoMemory) {
  at(0, 0);
  bus.fill_pixels(7, 1024 * 780);
  EXPECT_EQ(bus.read(Port::row), 0);
  at(1020, 1023);
  pixels({1, 2, 3, 4, 5});  // the last one lands in row 0
  EXPECT_EQ(machine.frame_buffer.read(0, 0), 5);
  at(0, 780);
  bus.fill_pixels(8, 244 * 1024 + 1);
  EXPECT_EQ(machine.frame_buffer.read(0, 0), 8);
  EXPECT_EQ(machine.frame_buffer.read(1, 0), 7);
  at(1023, 1023);
  EXPECT_EQ(read_pixels(2), (Ints{0, 8}));
}

// A frame around the picture in one plane leaves the picture alone, and goes as it came.
TEST_F(BusTest, AnOverlayPlaneIsDrawnAndTakenAway) {
  std::vector<std::uint8_t> row(1024);
  std::iota(row.begin(), row.end(), std::uint8_t{0});
  at(0, 10);
  bus.write_pixels(row);
  bus.write(Port::plane_mask, 0x80);
  at(100, 10);
  bus.fill_pixels(0xFF, 50);
  at(0, 10);
  auto seen = read_pixels(1024);
  for (std::size_t i = 0; i < 1024; ++i)
    ASSERT_EQ(seen[i], i >= 100 && i < 150 ? row[i] | 0x80 : row[i]) << i;
  at(0, 10);
  bus.fill_pixels(0, 1024);
  at(0, 10);
  seen = read_pixels(1024);
  for (std::size_t i = 0; i < 1024; ++i) ASSERT_EQ(seen[i], row[i] & 0x7F) << i;
}

// Two pictures of 4 planes each in one memory: the pixel mask shows one or the other.
TEST_F(BusTest, ThePixelMaskTurnsBetweenTwoPictures) {
  for (int i = 0; i < 16; ++i) {
    send(i, {i, 0, 0});
    send(i << 4, {0, i, 0});
  }
  at(0, 0);
  bus.write(Port::pixel, 0x5A);
  bus.write(Port::pixel_mask, 0x0F);
  EXPECT_EQ(machine.scan_out().at(0, 0), (Rgb8{dac_level(10), 0, 0}));
  bus.write(Port::pixel_mask, 0xF0);
  EXPECT_EQ(machine.scan_out().at(0, 0), (Rgb8{0, dac_level(5), 0}));
  at(0, 0);
  EXPECT_EQ(bus.read(Port::pixel), 0x5A);
}

TEST_F(BusTest, BlankedItIsBlackAndWritesLand) {
  send(0, {63, 63, 63});
  bus.write(Port::blank, 1);
  const Screen black = machine.scan_out();
  EXPECT_TRUE(std::all_of(black.pixels.begin(), black.pixels.end(),
                          [](Rgb8 pixel) { return pixel == Rgb8{}; }));
  EXPECT_EQ(machine.capture().palette[0], Rgb8{});
  EXPECT_EQ(machine.palette()[0], (Rgb8{255, 255, 255}));
  send(1, {63, 0, 0});
  at(4, 4);
  bus.write(Port::pixel, 1);
  bus.write(Port::blank, 0);
  EXPECT_EQ(machine.scan_out().at(4, 4), (Rgb8{255, 0, 0}));
  EXPECT_EQ(machine.scan_out().at(5, 4), (Rgb8{255, 255, 255}));
}

// The colour of the background changed at every tenth line: bars without a pixel drawn.
TEST_F(BusTest, ALutChangedInMidFrameGivesBars) {
  for (int line = 0; line < 780; line += 10) {
    bus.wait(line);
    send(0, {line % 64, 63 - line % 64, line / 13});
  }
  bus.wait(780);
  send(0, {1, 2, 3});  // in the blanking: for the next frame
  const Screen bars = raster.tube();
  for (int row = 0; row < 780; ++row) {
    const int line = row / 10 * 10;
    const DacCode codes{static_cast<std::uint8_t>(line % 64),
                        static_cast<std::uint8_t>(63 - line % 64),
                        static_cast<std::uint8_t>(line / 13)};
    ASSERT_EQ(bars.at(row % 1024, row), dac_colour(codes)) << row;
  }
  EXPECT_EQ(raster.frame(), bars);
  EXPECT_FALSE(raster.capture());
  bus.wait(0);
  EXPECT_EQ(raster.tube(), bars);
  EXPECT_EQ(raster.frame(), machine.scan_out());
  EXPECT_EQ(raster.capture(), machine.capture());
  EXPECT_EQ(raster.position().frames(), 1);
}

TEST_F(BusTest, APowerCycleIsANewMachine) {
  send(0, {63, 63, 63});
  at(5, 5);
  bus.write(Port::pixel, 9);
  bus.write(Port::blank, 1);
  bus.wait(300);
  bus.power_cycle({{5, 6, 5}});
  EXPECT_EQ(machine.dac(), (quant::DacBits{{5, 6, 5}}));
  EXPECT_EQ(machine.frame_buffer.read(5, 5), 0);
  EXPECT_EQ(bus.read(Port::blank), 0);
  EXPECT_EQ(raster.position().line(), 0);
  EXPECT_EQ(raster.tube(), Ma120().scan_out());
  EXPECT_THROW(bus.power_cycle({{5, 9, 5}}), std::invalid_argument);
}

TEST_F(BusTest, ALineOutsideTheFrameIsRefused) {
  EXPECT_THROW(bus.wait(-1), std::out_of_range);
  EXPECT_THROW(bus.wait(816), std::out_of_range);
  Bus alone(machine);
  EXPECT_THROW(alone.wait(816), std::out_of_range);
  alone.wait(815);
}

TEST_F(BusTest, ShowingAnImagePutsThisOnTheBus) {
  BusTally tally;
  bus.add_listener(tally);
  const std::vector<std::uint8_t> indices(640 * 480, 3);
  show_image(bus, {"S", {640, 480}, indices}, quant::Lut{});
  EXPECT_EQ(tally.bytes(Port::lut_write), 1u);
  EXPECT_EQ(tally.bytes(Port::lut_data), 3u * 256);
  EXPECT_EQ(tally.bytes(Port::pixel), 1024u * 780);
  EXPECT_EQ(tally.bytes(Port::column) + tally.bytes(Port::row), 4u);
  EXPECT_EQ(tally.bytes(), 1u + 768 + 798720 + 4 + 3);
  const Transfer transfer{tally.bytes(), 500e3};
  EXPECT_DOUBLE_EQ(transfer.seconds(), 799496 / 500e3);
  EXPECT_NEAR(transfer.frames(), 799496 / 500e3 * 65e6 / (1328.0 * 816), 1e-9);
}

TEST_F(BusTest, ShowingEndsBlankingAndNeedsNoStateBefore) {
  bus.write(Port::blank, 1);
  bus.write(Port::plane_mask, 1);
  at(500, 900);
  send(3, {1});
  const std::vector<std::uint8_t> indices{1, 2, 3, 4};
  quant::Lut lut;
  for (std::size_t i = 0; i < 256; ++i) lut.entry[i][1] = static_cast<std::uint8_t>(i % 64);
  show_image(bus, {"S", {2, 2}, indices}, lut);
  Ma120 fresh;
  show_image(fresh, {"S", {2, 2}, indices}, lut);
  EXPECT_EQ(machine.scan_out(), fresh.scan_out());
  EXPECT_EQ(machine.capture(), fresh.capture());
}

}  // namespace
}  // namespace sir::eltek
