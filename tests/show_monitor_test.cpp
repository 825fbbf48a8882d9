// sir show --monitor crt from outside.
#include <gmock/gmock.h>

#include "eltek/crt.h"
#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "quant/choose.h"
#include "quant/map_image.h"
#include "tests/cli_fixture.h"
#include "viewer/half_blocks.h"
#include "viewer/png_file.h"
#include "viewer/sixel.h"

namespace sir::test {
namespace {

using testing::HasSubstr;
using Names = std::vector<std::string>;

class ShowMonitor : public CliTest {
 protected:
  ShowMonitor() {
    render();
    const Planes image = read_planes(folder / "s", kSize);
    const quant::Lut lut = quant::choose_lut(image);
    eltek::Ma120 monitor;
    const eltek::Area area =
        show_image(monitor, {"s", kSize, quant::map_image(image, lut, {})}, lut);
    whole = monitor.capture();
    cropped = crop(whole, area);
    quant::write_lut(folder / "s.LUT", lut);
  }

  Ended show(Names more) const {
    more.insert(more.begin(), {"show", "s", "--size", "64x48"});
    return sir(more);
  }
  Ended show_crt(Names more) const {
    more.insert(more.end(), {"--monitor", "crt", "--png", "crt.png"});
    return show(more);
  }
  Planes png() const { return viewer::read_png(folder / "crt.png"); }
  static Planes tube(const eltek::CrtOptions& options, const eltek::IndexedScreen& screen) {
    return to_planes(eltek::Crt(options).show(screen));
  }

  static constexpr ImageSize kSize{64, 48};
  eltek::IndexedScreen whole, cropped;
};

TEST_F(ShowMonitor, APngOfTheTubeIsRgb) {
  const Ended ended = show_crt({});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(png(), tube({}, whole));
  constexpr std::size_t kColourType = 25;  // of a PNG's IHDR
  EXPECT_EQ(folder.read("crt.png")[kColourType], 2);
  EXPECT_EQ(show_crt({"--crop"}).exit_code, 0);
  EXPECT_EQ(png(), tube({}, cropped));
}

TEST_F(ShowMonitor, SaysItsNumbersUnlessItIsToBeQuiet) {
  EXPECT_EQ(show_crt({}).err,
            "monitor crt (our model: the thesis gives codes from 0 to 63 and no more)\n"
            "  light = 1 (code / largest code)^2.2\n"
            "  white d65 at 0.3127 0.329, as sRGB 255,255,255\n"
            "  phosphors smpte-c: red at 0.63 0.34, as sRGB 248,36,0; green at 0.31 0.595, "
            "63,251,0; blue at 0.155 0.07, 26,35,255\n");
  EXPECT_EQ(show_crt({"-q"}).err, "");
  const std::string all =
      show_crt({"--white", "9300k", "--phosphors", "p22-dosbox", "--gamma", "2.5", "--aspect",
                "--scale", "4", "--spot", "0.5", "--scanlines", "0.5"})
          .err;
  for (const char* part : {"^2.5", "9300k at 0.2831 0.2971", "p22-dosbox: red at 0.647 0.343",
                           "4x4 pixels for one; pixels 65:64; spot of sigma 0.5 pixels; scan lines "
                           "0.5, mean light x0.75"})
    EXPECT_THAT(all, HasSubstr(part));
}

TEST_F(ShowMonitor, OptionsReachTheTube) {
  using enum eltek::PhosphorSet;
  using enum eltek::WhitePoint;
  const struct {
    Names words;
    eltek::CrtOptions options;
  } cases[] = {
      {{"--phosphors", "p22-h273"}, {{p22_h273, d65, 2.2}}},
      {{"--phosphors", "p22-dosbox", "--white", "9300k"}, {{p22_dosbox, k9300, 2.2}}},
      {{"--gamma", "1.5"}, {{smpte_c, d65, 1.5}}},
      {{"--scale", "2"}, {{}, 2}},
      {{"--aspect"}, {{}, 1, true}},
      {{"--spot", "0.7"}, {{}, 1, false, 0.7}},
      {{"--scanlines", "0.6"}, {{}, 3, false, 0, 0.6}},
      {{"--scanlines", "0.6", "--scale", "4", "--aspect"}, {{}, 4, true, 0, 0.6}},
      {{"--scanlines", "0"}, {}},
  };
  for (const auto& one : cases) {
    Names words = one.words;
    words.push_back("--crop");
    const Ended ended = show_crt(words);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(png(), tube(one.options, cropped)) << one.words[0];
  }
}

TEST_F(ShowMonitor, TheIdealMonitorStaysAsItIs) {
  EXPECT_EQ(show({"--png", "plain.png"}).exit_code, 0);
  const Ended named = show({"--png", "named.png", "--monitor", "ideal"});
  EXPECT_EQ(named.exit_code, 0);
  EXPECT_EQ(named.err, "");
  EXPECT_EQ(folder.read("plain.png"), folder.read("named.png"));
}

TEST_F(ShowMonitor, ATubesOptionsWithoutATubeAreWrongUsage) {
  for (const Names& words : {Names{"--phosphors", "smpte-c"},
                             {"--white", "d65"},
                             {"--gamma", "2.2"},
                             {"--scale", "1"},
                             {"--aspect"},
                             {"--spot", "1"},
                             {"--scanlines", "0.5"}})
    for (const bool ideal : {false, true}) {
      Names all = words;
      all.insert(all.end(), {"--png", "x.png"});
      if (ideal) all.insert(all.end(), {"--monitor", "ideal"});
      const Ended ended = show(all);
      EXPECT_EQ(ended.exit_code, 2) << words[0];
      EXPECT_THAT(ended.err, HasSubstr(words[0] + ": belongs to --monitor crt"));
      EXPECT_FALSE(folder.has("x.png"));
    }
}

TEST_F(ShowMonitor, ValuesThatCannotBeAreWrongUsage) {
  for (const Names& words : {Names{"--phosphors", "p22"},
                             {"--white", "9300"},
                             {"--gamma", "0.5"},
                             {"--gamma", "4.5"},
                             {"--gamma", "nan"},
                             {"--scale", "0"},
                             {"--scale", "9"},
                             {"--scale", "1.5"},
                             {"--spot", "0"},
                             {"--spot", "6"},
                             {"--scanlines", "-0.1"},
                             {"--scanlines", "1.1"},
                             {"--scanlines", "0.5", "--scale", "2"}}) {
    const Ended ended = show_crt(words);
    EXPECT_EQ(ended.exit_code, 2) << words[1];
    EXPECT_THAT(ended.err, HasSubstr(words[0])) << words[1];
  }
  EXPECT_EQ(show({"--monitor", "lcd", "--png", "x.png"}).exit_code, 2);
}

TEST_F(ShowMonitor, InTheTerminalTheTubesColoursAreShown) {
  const eltek::Crt crt;
  eltek::IndexedScreen expected = cropped;
  expected.palette = crt.palette(cropped);
  expected.dac = {{8, 8, 8}};
  EXPECT_EQ(show({"--monitor", "crt", "--crop", "--terminal", "-q"}).out,
            viewer::sixel(expected) + "\n");
  const eltek::CrtOptions effects{{}, 3, true, 0.5, 0.5};
  EXPECT_EQ(show({"--monitor", "crt", "--crop", "--terminal=blocks", "-q", "--aspect", "--spot",
                  "0.5", "--scanlines", "0.5"})
                .out,
            viewer::half_blocks(eltek::Crt(effects).show(cropped), 80));
}

// A picture of more colours than a terminal has registers is shown with 256 that fit it.
TEST_F(ShowMonitor, EffectsInSixelsAreReducedTo256Colours) {
  const Ended ended = show({"--monitor", "crt", "--crop", "--terminal=sixel", "-q", "--spot", "1"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::StartsWith("\x1bPq\"1;1;64;48#"));
  const Ended scaled =
      show({"--monitor", "crt", "--crop", "--terminal=sixel", "-q", "--scale", "2"});
  EXPECT_THAT(scaled.out, testing::StartsWith("\x1bPq\"1;1;128;96#"));
}

}  // namespace
}  // namespace sir::test
