#include "eltek/trace_text.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "eltek/bus.h"
#include "eltek/trace_player.h"
#include "eltek/trace_recorder.h"
#include "tests/cases.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"

namespace sir::eltek {
namespace {

// One of everything, as a person may write it.
const std::string kSample =
    "# A session\n\n"
    "MA120 trace 1 dac 6 6 6\n"
    "lut.write 0   # the first entry\n"
    "LUT.data 63\r\n"
    "  blank ON\n"
    "blank off\n"
    "column 1023\n"
    "pixel 4d*192 00 1F\n"
    "read lut.data 63\n"
    "read lut.data ?\n"
    "read blank off\n"
    "read pixel 4D*3 ?*2\n"
    "wait 815\n"
    "power 5 6 8\n"
    "end 12\n"
    "# no more\n";

std::string error_of(const std::string& text) {
  try {
    parse_trace("T", text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

// A trace of these lines; the second line of the file is the first of them.
std::string trace_of(const std::string& lines, int records) {
  return "MA120 trace 1 dac 6 6 6\n" + lines + "end " + std::to_string(records) + "\n";
}

TEST(TraceText, ReadsEveryKindOfRecord) {
  const Trace trace = parse_trace("T", kSample);
  EXPECT_EQ(trace.dac(), quant::DacBits{});
  ASSERT_EQ(trace.records().size(), 12u);
  EXPECT_EQ(trace.records()[0], TraceRecord(PortWrite{Port::lut_write, 0}));
  EXPECT_EQ(trace.records()[1], TraceRecord(PortWrite{Port::lut_data, 63}));
  EXPECT_EQ(trace.records()[2], TraceRecord(PortWrite{Port::blank, 1}));
  EXPECT_EQ(trace.records()[6], TraceRecord(PortRead{Port::lut_data, 63}));
  EXPECT_EQ(trace.records()[7], TraceRecord(PortRead{Port::lut_data, std::nullopt}));
  EXPECT_EQ(trace.records()[10], TraceRecord(Wait{815}));
  EXPECT_EQ(trace.records()[11], TraceRecord(PowerCycle{{{5, 6, 8}}}));
  const auto& written = std::get<PixelWrite>(trace.records()[5]);
  EXPECT_EQ(written.count, 194u);
  EXPECT_EQ(trace.runs(written)[0], PixelRun(192, 0x4D));
  EXPECT_EQ(trace.runs(written)[2], PixelRun(1, 0x1F));
  const auto& read = std::get<PixelRead>(trace.records()[9]);
  EXPECT_EQ(trace.runs(read)[1], PixelRun(2, std::nullopt));
}

TEST(TraceText, WritesWhatItReads) {
  const std::string text = trace_text(parse_trace("T", kSample));
  EXPECT_EQ(text,
            "MA120 trace 1 dac 6 6 6\nlut.write 0\nlut.data 63\nblank on\nblank off\n"
            "column 1023\npixel 4D*192 00 1F\nread lut.data 63\nread lut.data ?\n"
            "read blank off\nread pixel 4D*3 ?*2\nwait 815\npower 5 6 8\nend 12\n");
  EXPECT_EQ(parse_trace("T", text), parse_trace("T", kSample));
  const test::TempFolder folder;
  write_trace(folder / "t.trace", parse_trace("T", kSample));
  EXPECT_EQ(folder.read("t.trace"), text);
  EXPECT_EQ(folder.list(), std::vector<std::string>{"t.trace"});
  EXPECT_EQ(read_trace(folder / "t.trace"), parse_trace("T", kSample));
  EXPECT_THROW(write_trace(folder / "none" / "t.trace", Trace()), FileError);
  EXPECT_THROW(read_trace(folder / "other.trace"), FileError);
}

TEST(TraceText, AnEmptySessionIsATrace) {
  EXPECT_EQ(trace_text(Trace(quant::DacBits{{4, 4, 4}})), "MA120 trace 1 dac 4 4 4\nend 0\n");
  EXPECT_EQ(parse_trace("T", trace_text(Trace(quant::DacBits{{4, 4, 4}}))),
            Trace(quant::DacBits{{4, 4, 4}}));
}

struct Bad {
  std::string line, reason;
};

TEST(TraceText, WrongLinesAreNamed) {
  for (const Bad& bad : std::vector<Bad>{
           {"lut.write 256", "lut.write takes an integer from 0 to 255, not \"256\""},
           {"lut.data -1", "lut.data takes an integer from 0 to 255, not \"-1\""},
           {"lut.data 1.5", "\"1.5\""},
           {"mask", "mask takes an integer from 0 to 255"},
           {"planes 0x10", "\"0x10\""},
           {"column 1024", "column takes an integer from 0 to 1023"},
           {"row 99999999999999999999", "row takes an integer from 0 to 1023"},
           {"blank 1", "blank takes on or off"},
           {"mask 1 2", "\"2\" stands where the line should end"},
           {"lut 5", "\"lut\" is no register and no word of a trace"},
           {"read wait 5", "\"wait\" is no register"},
           {"read", "is no register"},
           {"read mask", "mask takes an integer"},
           {"wait 816", "wait takes an integer from 0 to 815"},
           {"power 6 6", "a DAC's primary takes an integer from 1 to 8"},
           {"power 6 6 9", "not \"9\""},
           {"pixel", "two hexadecimal digits"},
           {"pixel 4", "\"4\" is not an index of two hexadecimal digits"},
           {"pixel 4G", "\"4G\""},
           {"pixel 004", "\"004\""},
           {"pixel ?", "\"?\" is not an index"},
           {"read pixel ??", "two hexadecimal digits or ?"},
           {"pixel 00*", "a number of equal pixels takes an integer from 1 to 798720"},
           {"pixel 00*0", "not \"0\""},
           {"pixel 00*-3", "not \"-3\""},
           {"pixel 00*798721", "a number of equal pixels"},
           {"pixel 00*18446744073709551617", "a number of equal pixels"},
           {"pixel 00*798720 00", "more than 798720 pixels, the screen's, at once"},
       }) {
    const std::string error = error_of(trace_of("mask 1\n" + bad.line + "\n", 2));
    EXPECT_EQ(error.find("T:3: "), 0u) << bad.line << ": " << error;
    EXPECT_NE(error.find(bad.reason), std::string::npos) << bad.line << ": " << error;
    EXPECT_EQ(error.find("cut off"), std::string::npos) << error;
  }
}

TEST(TraceText, TheFirstLineIsLookedAtClosely) {
  for (const Bad& bad : std::vector<Bad>{
           {"", "T: the trace is cut off"},
           {"MA12\n", "T:1: no trace of the MA120, or one that is cut off"},
           {"hello\nmask 1\nend 1\n", "T:1: no trace of the MA120"},
           {"MA120 trace 2 dac 6 6 6\nend 0\n", "T:1: version \"2\" of the trace is not known"},
           {"MA120 trace 1\nend 0\n", "T:1: dac and its bits are missing"},
           {"MA120 trace 1 dac 6 6 0\nend 0\n",
            "T:1: a DAC's primary takes an integer from 1 to 8"},
           {"MA120 trace 1 dac 6 6 6 6\nend 0\n", "where the line should end"},
       })
    EXPECT_EQ(error_of(bad.line).find(bad.reason) != std::string::npos, true)
        << bad.line << " gives: " << error_of(bad.line);
}

TEST(TraceText, TheLastLineCounts) {
  EXPECT_NE(error_of(trace_of("mask 1\n", 2)).find("cut off"), std::string::npos);
  EXPECT_NE(error_of(trace_of("mask 1\n", 0)).find("counts 0 records, the trace has 1"),
            std::string::npos);
  EXPECT_EQ(error_of(trace_of("mask 1\n", 1) + "mask 1\n"), "T:4: there is more after the end");
  EXPECT_EQ(error_of(trace_of("", 0) + "\n# more\n"), "");
}

// Wherever a trace breaks off, it is said so with the place.
TEST(TraceText, ACutTraceIsDetectedAtEveryByte) {
  const std::string whole = trace_text(parse_trace("T", kSample));
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    const std::string error = error_of(whole.substr(0, length));
    ASSERT_NE(error.find("cut off"), std::string::npos) << length << ": " << error;
    ASSERT_EQ(error.find("T:"), 0u) << error;
  }
  EXPECT_EQ(error_of(whole.substr(0, whole.size() - 1)), "");  // the last newline alone
}

// Bytes changed, doubled and left out: a trace is read and can be played, or the error has a place.
TEST(TraceText, DamagedTracesAreReadOrLocated) {
  std::mt19937 random(3);
  std::uint64_t read = 0;
  for (std::uint64_t i = 0; i < test::cases(4000); ++i) {
    std::string text = kSample;
    for (auto changes = random() % 3 + 1; changes > 0; --changes) {
      const std::size_t place = random() % text.size();
      switch (random() % 3) {
        case 0: text[place] = "0123456789aF*?# \nx"[random() % 18]; break;
        case 1: text.insert(place, text.substr(place, random() % 20)); break;
        default: text.erase(place, random() % 4); break;
      }
    }
    try {
      TracePlayer player(parse_trace("T", text));
      player.seek(player.count());
      ++read;
    } catch (const FileError& error) {
      ASSERT_EQ(std::string(error.what()).find("T:"), 0u) << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(read, test::cases(4000) / 40);
}

// Runs stay runs: what 3000 lines ask for is 2 gigapixels; it is refused at the limit, and what
// is kept until then is 4 bytes a line and the record.
TEST(TraceText, LongRunsAreKeptAsRunsAndLimited) {
  std::string lines;
  for (int i = 0; i < 1344; ++i) lines += "pixel 00*798720\n";
  const Trace trace = parse_trace("T", trace_of(lines, 1344));
  EXPECT_EQ(trace.runs(std::get<PixelWrite>(trace.records()[1343])).size(), 1u);
  EXPECT_FALSE(trace.has_room_for(1, Trace::kMaxBurst));
  const std::string error = error_of(trace_of(lines + lines, 2688));
  EXPECT_EQ(error.find("T:1346: more than 1073741824 pixels"), 0u) << error;
  std::string power;
  for (int i = 0; i < 1345; ++i) power += "power 6 6 6\n";
  EXPECT_EQ(error_of(trace_of(power, 1345)).find("T:1346: "), 0u);
}

TEST(Trace, RefusesMoreThanItHolds) {
  Trace trace;
  const std::vector<PixelRun> runs{{Trace::kMaxBurst, 1}, {1, 1}};
  EXPECT_THROW(trace.add_pixel_write(runs), std::length_error);
  EXPECT_TRUE(trace.records().empty());
}

class RecorderTest : public testing::Test {
 protected:
  RecorderTest() { bus.add_listener(recorder); }
  std::string text() const { return trace_text(recorder.trace()); }

  Ma120 machine;
  Bus bus{machine};
  TraceRecorder recorder;
};

TEST_F(RecorderTest, WritesDownWhatPasses) {
  bus.write(Port::lut_write, 3);
  bus.write(Port::lut_data, 255);
  bus.write(Port::pixel_mask, 0x1FF);
  bus.write(Port::pixel, 7);
  bus.write_pixels(std::vector<std::uint8_t>{1, 1, 1, 2});
  bus.write_pixels({});
  bus.fill_pixels(9, 5);
  bus.write(Port::column, 0);
  bus.read(Port::pixel);
  std::vector<std::uint8_t> back(4);
  bus.read_pixels(back);
  bus.write(Port::lut_read, 0);
  bus.read(Port::lut_data);
  bus.write(Port::blank, 1);
  bus.read(Port::blank);
  bus.wait(400);
  bus.power_cycle({{5, 6, 5}});
  EXPECT_EQ(
      text(),
      "MA120 trace 1 dac 6 6 6\nlut.write 3\nlut.data 255\nmask 255\npixel 07\n"
      "pixel 01*3 02\npixel 09*5\ncolumn 0\nread pixel 07\nread pixel 01*3 02\n"
      "lut.read 0\nread lut.data 0\nblank on\nread blank on\nwait 400\npower 5 6 5\nend 15\n");
  EXPECT_EQ(parse_trace("T", text()), recorder.trace());
}

TEST_F(RecorderTest, ADacFittedFirstStandsInTheFirstLine) {
  bus.power_cycle({{5, 6, 5}});
  bus.write(Port::pixel_mask, 1);
  EXPECT_EQ(text(), "MA120 trace 1 dac 5 6 5\nmask 1\nend 1\n");
}

TEST_F(RecorderTest, ALongBurstBecomesSeveralRecords) {
  bus.write_pixels(std::vector<std::uint8_t>(Trace::kMaxBurst + 10, 4));
  bus.fill_pixels(5, 2 * std::size_t{Trace::kMaxBurst} + 1);
  EXPECT_EQ(text(),
            "MA120 trace 1 dac 6 6 6\npixel 04*798720\npixel 04*10\npixel 05*798720\n"
            "pixel 05*798720\npixel 05\nend 5\n");
  std::vector<std::uint8_t> busy(100'000);
  for (std::size_t i = 0; i < busy.size(); ++i) busy[i] = static_cast<std::uint8_t>(i % 7);
  bus.write_pixels(busy);
  EXPECT_EQ(recorder.trace().records().size(), 7u);  // a line has 65536 runs at most
  EXPECT_EQ(parse_trace("T", text()), recorder.trace());
}

TEST_F(RecorderTest, AFullTraceIsStillOne) {
  for (int i = 0; i < 1344; ++i) bus.fill_pixels(static_cast<std::uint8_t>(i), Trace::kMaxBurst);
  EXPECT_FALSE(recorder.full());
  bus.fill_pixels(1, Trace::kMaxBurst);
  EXPECT_TRUE(recorder.full());
  bus.write(Port::pixel_mask, 1);  // nothing after what is missing
  EXPECT_EQ(recorder.trace().records().size(), 1344u);
  EXPECT_EQ(parse_trace("T", text()), recorder.trace());
}

}  // namespace
}  // namespace sir::eltek
