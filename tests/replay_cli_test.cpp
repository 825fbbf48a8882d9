// sir show --trace, sir show --bus and sir replay from outside.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "eltek/screen_hash.h"
#include "eltek/trace_player.h"
#include "eltek/trace_text.h"
#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using Names = std::vector<std::string>;

class Replay : public CliTest {
 protected:
  Replay() { render(); }

  Ended show(Names more) const {
    more.insert(more.begin(), {"show", "s", "--size", "64x48", "-q"});
    return sir(more);
  }

  // A trace of these lines.
  std::string trace(const std::string& lines, int records) const {
    folder.write("t",
                 "MA120 trace 1 dac 6 6 6\n" + lines + "end " + std::to_string(records) + "\n");
    return "t";
  }
};

TEST_F(Replay, GivesThePictureThatWasShownByteForByte) {
  EXPECT_EQ(sir({"lut", "s", "--size", "64x48", "--bits", "5,6,5", "--method", "best", "-o",
                 "high.LUT", "-q"})
                .exit_code,
            0);
  for (const Names& more : {Names{}, Names{"--dither", "floyd"}, Names{"--lut", "high.LUT"}}) {
    Names plain{"--png", "plain.png"}, traced{"--png", "a.png", "--trace", "a.trace"};
    for (Names* arguments : {&plain, &traced}) {
      arguments->insert(arguments->end(), more.begin(), more.end());
      const Ended shown = show(*arguments);
      EXPECT_EQ(shown.exit_code, 0) << shown.err;
      EXPECT_EQ(shown.out, "");
    }
    const Ended replayed = sir({"replay", "a.trace", "--png", "b.png"});
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_TRUE(folder.read("b.png") == folder.read("a.png"));
    EXPECT_TRUE(folder.read("plain.png") == folder.read("a.png"));  // a trace changes nothing
  }
}

TEST_F(Replay, SaysWhatTheTraceHolds) {
  show({"--png", "a.png", "--trace", "a.trace"});
  const Ended ended = sir({"replay", "a.trace", "--json"});
  EXPECT_EQ(ended.err, "");
  const json said = json::parse(ended.out);
  EXPECT_EQ(said["records"], 1 + 768 + 3 + 2 + 780);
  EXPECT_EQ(said["played"], said["records"]);
  EXPECT_EQ(said["dac"], json({6, 6, 6}));
  EXPECT_EQ(said["writes"], json({{"lut.write", 1},
                                  {"lut.data", 768},
                                  {"mask", 1},
                                  {"planes", 1},
                                  {"column", 1},
                                  {"row", 1},
                                  {"pixel", 798720},
                                  {"blank", 1}}));
  EXPECT_EQ(said["reads"], json::object());
  EXPECT_EQ(said["indexed"], true);
  eltek::TracePlayer player(eltek::read_trace(folder / "a.trace"));
  player.seek(player.count());
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx",
                static_cast<unsigned long long>(eltek::hash(player.raster().frame())));
  EXPECT_EQ(said["hash"], hash);

  const Ended text = sir({"replay", "a.trace"});
  EXPECT_THAT(text.out, HasSubstr("1554 of 1554 records played; DAC 6,6,6\n"));
  EXPECT_THAT(text.out, HasSubstr("\nlast: 1024 pixels of index 18 from column 0, row 779\n"));
  EXPECT_THAT(text.out, HasSubstr("lut.data 768, mask 1"));
  EXPECT_THAT(text.out, HasSubstr(std::string("\nframe: ") + hash + "\n"));
}

TEST_F(Replay, StopsAfterSoManyRecords) {
  trace("lut.data 63\nlut.data 0\nlut.data 63\nwait 5\nlut.write 0\n", 5);
  const auto first = [&](const std::string& steps) {
    const Ended ended = sir({"replay", "t", "--steps", steps, "--png", "f.png", "--json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(json::parse(ended.out)["played"], std::min(5, std::stoi(steps)));
    return viewer::read_png(folder / "f.png").at(0);
  };
  EXPECT_EQ(first("0"), Rgb8{});
  EXPECT_EQ(first("2"), Rgb8{});
  EXPECT_EQ(first("3"), (Rgb8{255, 0, 255}));
  EXPECT_EQ(first("99"), (Rgb8{255, 0, 255}));
  for (const char* wrong : {"-1", "x", "1.5", ""})
    EXPECT_EQ(sir({"replay", "t", "--steps", wrong}).exit_code, 2) << wrong;
}

TEST_F(Replay, BarsOfManyPalettesBecomeAnRgbPicture) {
  std::string lines;
  for (int line = 0; line < 780; line += 78)
    lines += "wait " + std::to_string(line) + "\nlut.write 0\nlut.data " +
             std::to_string(line / 78) + "\nlut.data 0\nlut.data 0\n";
  trace(lines, 50);
  const Ended ended = sir({"replay", "t", "--png", "bars.png"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(", of more than one palette"));
  EXPECT_THAT(ended.out, HasSubstr("beam: line 702 of frame 0, after 10 waits"));
  const std::string png = folder.read("bars.png");
  EXPECT_EQ(png[25], 2);  // colour type: RGB
  const Planes bars = viewer::read_png(folder / "bars.png");
  for (std::size_t row = 0; row < 780; ++row)
    ASSERT_EQ(bars.at(row * 1024 + row),
              (Rgb8{quant::seen_byte(static_cast<int>(row / 78)), 0, 0}));
}

// The manual's example is a trace, and gives what the manual says.
TEST_F(Replay, PlaysTheManualsExample) {
  std::ifstream manual(std::filesystem::path(SIR_CLAIM).parent_path() / "ma120.md");
  const std::string text{std::istreambuf_iterator<char>(manual), {}};
  const auto start = text.find("MA120 trace 1 ");
  ASSERT_NE(start, std::string::npos);
  folder.write("t", text.substr(start, text.find("```", start) - start));
  const Ended ended = sir({"replay", "t", "--png", "t.png"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Planes frame = viewer::read_png(folder / "t.png");
  const std::uint8_t c40 = quant::seen_byte(40);
  EXPECT_EQ(frame.at(0), (Rgb8{0, 0, c40}));
  EXPECT_EQ(frame.at(259 * 1024), (Rgb8{0, 0, c40}));
  EXPECT_EQ(frame.at(260 * 1024), (Rgb8{255, 255, 0}));
  EXPECT_EQ(frame.at(520 * 1024), (Rgb8{c40, 0, 0}));
  for (std::size_t column = 0; column < 1024; ++column)
    EXPECT_EQ(frame.at(389 * 1024 + column) == Rgb8{}, column >= 503 && column < 521) << column;
}

TEST_F(Replay, BadTracesAreLocated) {
  show({"--png", "a.png", "--trace", "a.trace"});
  const std::string whole = folder.read("a.trace");
  folder.write("cut", whole.substr(0, whole.size() / 2));
  expect_failure(sir({"replay", "cut"}), "the trace is cut off");
  folder.write("lines", whole.substr(0, whole.rfind("end ")));
  expect_failure(sir({"replay", "lines"}), "lines:1555: the trace is cut off");
  expect_failure(sir({"replay", trace("mask 1\nmask 256\nmask 1\n", 3)}),
                 "t:3: mask takes an integer from 0 to 255");
  expect_failure(sir({"replay", "none"}), "none: cannot be read");
  expect_failure(sir({"replay", "s.png"}), "s.png:1: no trace of the MA120");
  const Ended reads = sir({"replay", trace("read mask 255\nread mask 7\n", 2)});
  expect_failure(reads, "t: record 2: mask reads 255 where the trace says 7");
  EXPECT_THAT(reads.out, HasSubstr("2 of 2 records"));
}

TEST_F(Replay, OverwritesNoInput) {
  const std::string text = folder.read(trace("mask 1\n", 1));
  expect_failure(sir({"replay", "t", "--png", "t"}), "t");
  EXPECT_EQ(folder.read("t"), text);
  expect_failure(sir({"replay", "t", "--png", "s.LUT"}), "s.LUT");
  sir({"lut", "s", "--size", "64x48", "-q"});
  const auto before = folder.list();
  for (const char* trace_name : {"s.R", "s.LUT", "s.CSG"})
    expect_failure(show({"--png", "x.png", "--trace", trace_name}), trace_name);
  expect_failure(show({"--png", "x.png", "--trace", "./x.png"}), "both the trace and the picture");
  EXPECT_EQ(folder.list(), before);
}

TEST_F(Replay, AFullDiskIsReported) {
  expect_failure(show({"--png", "a.png", "--trace", "/dev/full"}), "/dev/full: ");
}

TEST_F(Replay, BusSaysWhatShowingTakes) {
  for (const auto& [rate, said] : std::vector<std::pair<std::string, std::string>>{
           {"500k", "at 500000 bytes/s 1.599 s, 95.91 frames"},
           {"1.2M", "at 1200000 bytes/s 0.6662 s, 39.96 frames"},
           {"799496", "at 799496 bytes/s 1 s, 59.98 frames"}}) {
    const Ended ended = show({"--png", "a.png", "--bus", rate, "--trace", "a.trace"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("s: 799496 bytes on the bus: LUT 769, pixels 798720, other "
                                     "registers 7\n"));
    EXPECT_THAT(ended.out, HasSubstr(said));
  }
  for (const char* wrong : {"0", "-5", "5G", "k", "", "nan", "1e16"})
    EXPECT_EQ(show({"--png", "a.png", "--bus", wrong}).exit_code, 2) << wrong;
}

#ifdef SIR_WITH_SDL
TEST_F(Replay, AWindowIsNotOpenedForWhatIsWrongFromTheStart) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  sir({"lut", "s", "--size", "64x48", "-q"});
  const std::string lut = folder.read("s.LUT");
  expect_failure(show({"--trace", "s.LUT"}), "s.LUT");
  EXPECT_EQ(folder.read("s.LUT"), lut);
  expect_failure(show({"--lut", "none.LUT"}), "none.LUT: cannot be read");
  folder.write("bad.LUT", "1 2 64\n");
  expect_failure(show({"--lut", "bad.LUT"}), "bad.LUT:1");
  const std::string played = trace("mask 1\n", 1);
  EXPECT_EQ(sir({"replay", played, "--window", "--png", "x.png"}).exit_code, 2);
  EXPECT_EQ(sir({"replay", played, "--window", "--json"}).exit_code, 2);
  ::setenv("SDL_VIDEODRIVER", "none of them", 1);
  expect_failure(sir({"replay", "none", "--window"}), "none: cannot be read");
  expect_failure(sir({"replay", played, "--window"}), "window: ");
  ::unsetenv("SDL_VIDEODRIVER");
}

TEST_F(Replay, AWindowTellsOfReadsThatDiffer) {
  const std::string played = trace("lut.write 0\nlut.read 5\nread lut.data 7\n", 3);
  const Ended ended = sir({"replay", played});
  const std::size_t reason = ended.err.find("record 3: lut.data reads 0 where the trace says 7");
  ASSERT_NE(reason, std::string::npos) << ended.err;
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  Start start;
  start.folder = folder.path();
  Program program(SIR_PROGRAM, {"replay", played, "--window"}, start);
  EXPECT_TRUE(program.wait_for("record 3: lut.data reads 0 where the trace says 7"));
  program.signal(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  ::unsetenv("SDL_VIDEODRIVER");
}

TEST_F(Replay, AWindowsSessionIsWrittenWhenItCloses) {
  ::setenv("SDL_VIDEODRIVER", "dummy", 1);
  Start start;
  start.folder = folder.path();
  Program program(SIR_PROGRAM, {"show", "s", "s", "--size", "64x48", "--trace", "w.trace"}, start);
  ASSERT_TRUE(program.wait_for("median in hsv"));  // images are being prepared
  program.signal(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  ::unsetenv("SDL_VIDEODRIVER");
  show({"--png", "a.png", "--trace", "a.trace"});
  EXPECT_EQ(folder.read("w.trace"), folder.read("a.trace"));
}
#endif

}  // namespace
}  // namespace sir::test
