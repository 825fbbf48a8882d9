#include "eltek/trace_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "eltek/display_driver.h"
#include "eltek/trace_recorder.h"
#include "eltek/trace_text.h"

namespace sir::eltek {
namespace {

// What a position of a trace is: all that can be seen of it.
struct Seen {
  Screen tube, frame;
  std::int64_t scanned;
  int column, row;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen look(const TracePlayer& player) {
  return {player.raster().tube(), player.raster().frame(), player.raster().position().scanned(),
          player.machine().pixel_address.column(), player.machine().pixel_address.row()};
}

Trace parse(const std::string& lines, int records) {
  return parse_trace("T", "MA120 trace 1 dac 6 6 6\n" + lines + "end " + std::to_string(records));
}

// Screens of noise, with waits, LUT writes, power cycles and reads between: long enough that
// states are kept on the way.
Trace long_trace() {
  Ma120 machine;
  Raster raster(machine);
  Bus bus(machine, &raster);
  TraceRecorder recorder;
  bus.add_listener(recorder);
  std::mt19937 random(5);
  std::vector<std::uint8_t> noise(3000);
  for (int round = 0; round < 40; ++round) {
    bus.fill_pixels(static_cast<std::uint8_t>(random()), Trace::kMaxBurst / 2);
    for (auto& index : noise) index = static_cast<std::uint8_t>(random());
    bus.write_pixels(noise);
    bus.wait(static_cast<int>(random() % 816));
    bus.write(Port::lut_write, static_cast<std::uint8_t>(random()));
    for (int i = 0; i < 30; ++i) bus.write(Port::lut_data, static_cast<std::uint8_t>(random()));
    if (round == 17) bus.power_cycle({{5, 6, 5}});
    std::vector<std::uint8_t> back(100);
    bus.read_pixels(back);
    bus.write(Port::pixel_mask, static_cast<std::uint8_t>(random() | 0x3F));
    bus.wait(static_cast<int>(random() % 816));
  }
  return recorder.trace();
}

TEST(TracePlayer, StepsToTheEndAndNoFurther) {
  TracePlayer player(parse("lut.data 63\nlut.data 0\nlut.data 63\nmask 7\n", 4));
  EXPECT_EQ(player.count(), 4u);
  EXPECT_EQ(player.machine().scan_out().at(0, 0), Rgb8{});
  for (int i = 1; i <= 4; ++i) {
    EXPECT_TRUE(player.step());
    EXPECT_EQ(player.position(), static_cast<std::size_t>(i));
    EXPECT_EQ(player.raster().frame().at(0, 0), i < 3 ? Rgb8{} : (Rgb8{255, 0, 255}));
  }
  EXPECT_FALSE(player.step());
  player.seek(2);
  EXPECT_EQ(player.machine().lut_ports.pixel_mask(), 0xFF);
  EXPECT_EQ(player.machine().lut_ports.phase(), 2u);
  EXPECT_THROW(player.seek(5), std::out_of_range);
}

TEST(TracePlayer, SeekingIsSteppingInAnyOrder) {
  const Trace trace = long_trace();
  TracePlayer stepper(trace);
  TracePlayer seeker(trace);
  std::vector<std::size_t> places{0, 1, trace.records().size()};
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i) places.push_back(random() % trace.records().size());
  std::sort(places.begin(), places.end());
  std::vector<Seen> seen;
  for (const std::size_t place : places) {
    while (stepper.position() < place) ASSERT_TRUE(stepper.step());
    seen.push_back(look(stepper));
  }
  for (int i = 0; i < 60; ++i) {
    const std::size_t which = random() % places.size();
    seeker.seek(places[which]);
    ASSERT_EQ(seeker.position(), places[which]);
    ASSERT_TRUE(look(seeker) == seen[which]) << i << ": record " << places[which];
  }
  EXPECT_FALSE(seeker.difference());
}

// Every read of the session is found again.
TEST(TracePlayer, AReadThatDiffersIsTold) {
  TracePlayer player(
      parse("pixel 05*3\ncolumn 1\nread pixel 05 ? 00\nread pixel 06\n"
            "read mask 255\nread mask 254\nread row ?\n",
            7));
  player.seek(3);
  EXPECT_FALSE(player.difference());
  player.seek(7);
  ASSERT_TRUE(player.difference());
  EXPECT_EQ(player.difference()->record, 3u);
  EXPECT_EQ(player.difference()->port, Port::pixel);
  EXPECT_EQ(player.difference()->expected, 6);
  EXPECT_EQ(player.difference()->found, 0);
  player.seek(2);
  EXPECT_FALSE(player.difference());
  TracePlayer mask(parse("read mask 254\n", 1));
  mask.step();
  EXPECT_EQ(mask.difference()->found, 255);
}

TEST(TracePlayer, ShowingAnImageCanBePlayedBack) {
  Ma120 machine;
  Bus bus(machine);
  TraceRecorder recorder;
  bus.add_listener(recorder);
  std::vector<std::uint8_t> indices(640 * 480);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint8_t>(i / 1000);
  quant::Lut lut;
  for (std::size_t i = 0; i < 256; ++i) lut.entry[i][0] = static_cast<std::uint8_t>(i / 4);
  show_image(bus, {"S", {640, 480}, indices}, lut);
  TracePlayer player(parse_trace("T", trace_text(recorder.trace())));
  player.seek(player.count());
  EXPECT_EQ(player.raster().frame(), machine.scan_out());
  EXPECT_EQ(player.raster().capture(), machine.capture());
}

TEST(TracePlayer, DescribesEveryRecord) {
  const TracePlayer player(
      parse("lut.write 255\nlut.data 1\nlut.data 2\nlut.data 255\nlut.data 9\nread lut.data ?\n"
            "lut.read 0\nread lut.data 9\nmask 0\nmask 129\nplanes 255\ncolumn 1000\nrow 5\n"
            "pixel 00 01*1024\npixel 0A*2\nread pixel ?*3\nrow 900\npixel 01\nblank on\nblank off\n"
            "wait 800\nwait 3\npower 5 6 5\nlut.data 3\n",
            24));
  const std::vector<std::string> expected{
      "LUT write address 255",
      "LUT entry 255 red 1",
      "LUT entry 255 green 2",
      "LUT entry 255 blue 255, now 1 2 63",
      "LUT entry 0 red 9",
      "reads LUT entry 0 green: ?",
      "LUT read address 0",
      "reads LUT entry 0 red: 9",
      "pixel mask 0: no planes seen",
      "pixel mask 129: planes 1 8 seen",
      "plane mask 255: all planes written",
      "column 1000",
      "row 5",
      "1025 pixels from column 1000, row 5",
      "2 pixels of index 10 from column 1001, row 6",
      "reads 3 pixels from column 1003, row 6",
      "row 900, where no memory is",
      "1 pixel of index 1 from column 1006, row 900, where no memory is",
      "blanked",
      "no longer blanked",
      "waits for line 800, in the vertical blanking",
      "waits for line 3 of the next frame",
      "off and on, with a DAC of 5,6,5 bits",
      "LUT entry 0 red 3"};
  ASSERT_EQ(player.count(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(player.describe(i), expected[i]);
  EXPECT_THROW(player.describe(24), std::out_of_range);
}

TEST(TracePlayer, DescribesRecordsFarBehindTheFirst) {
  std::string lines;
  for (int i = 0; i < 10'000; ++i) lines += "lut.data 1\n";
  const TracePlayer player(parse(lines, 10'000));
  for (const std::size_t i : {4095u, 4096u, 4097u, 8192u, 9999u})
    EXPECT_EQ(player.describe(i).find("LUT entry " + std::to_string(i / 3 % 256) + " " +
                                      (i % 3 == 0   ? "red"
                                       : i % 3 == 1 ? "green"
                                                    : "blue")),
              0u)
        << player.describe(i);
}

TEST(TracePlayer, AnEmptyTraceIsAMachineAtPowerOn) {
  TracePlayer player{Trace(quant::DacBits{{4, 4, 4}})};
  EXPECT_FALSE(player.step());
  player.seek(0);
  EXPECT_EQ(player.machine().dac(), (quant::DacBits{{4, 4, 4}}));
  EXPECT_EQ(player.raster().frame(), Ma120().scan_out());
}

}  // namespace
}  // namespace sir::eltek
