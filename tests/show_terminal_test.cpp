// sir show --terminal from outside.
#include <gmock/gmock.h>
#include <signal.h>
#include <termios.h>

#include <cstddef>

#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "quant/choose.h"
#include "quant/map_image.h"
#include "tests/at_terminal.h"
#include "tests/cli_fixture.h"
#include "viewer/half_blocks.h"
#include "viewer/png_file.h"
#include "viewer/sixel.h"

namespace sir::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Names = std::vector<std::string>;

constexpr const char* kQuestion = "\x1b[c";

class ShowTerminal : public CliTest {
 protected:
  ShowTerminal() {
    render();
    image = read_planes(folder / "s", kSize);
    lut = quant::choose_lut(image);
    area = show_image(monitor, {"s", kSize, quant::map_image(image, lut, {})}, lut);
  }

  static Names words(Names more) {
    more.insert(more.begin(), {"show", "s", "--size", "64x48", "-q"});
    return more;
  }
  Ended show(Names more) const { return sir(words(std::move(more))); }

  eltek::IndexedScreen cropped() const { return crop(monitor.capture(), area); }
  std::string blocks(int columns) const {
    return viewer::half_blocks(crop(monitor.scan_out(), area), columns);
  }

  static constexpr ImageSize kSize{64, 48};
  Planes image;
  quant::Lut lut;
  eltek::Ma120 monitor;
  eltek::Area area;
};

TEST_F(ShowTerminal, ToAFileItIsSixels) {
  const Ended whole = show({"--terminal"});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.err, "");
  EXPECT_EQ(whole.out, viewer::sixel(monitor.capture()) + "\n");
  EXPECT_EQ(show({"--terminal", "--crop"}).out, viewer::sixel(cropped()) + "\n");
  EXPECT_EQ(show({"--terminal=sixel", "--crop"}).out, viewer::sixel(cropped()) + "\n");
  EXPECT_EQ(show({"--terminal=auto", "--crop"}).out, viewer::sixel(cropped()) + "\n");
}

TEST_F(ShowTerminal, HalfBlocksToAFileAre80CharactersWide) {
  EXPECT_EQ(show({"--terminal=blocks", "--crop"}).out, blocks(80));
  EXPECT_EQ(show({"--terminal=blocks"}).out, viewer::half_blocks(monitor.scan_out(), 80));
}

TEST_F(ShowTerminal, WhatFollowsTheBareOptionIsAnImage) {
  EXPECT_EQ(sir({"show", "--terminal", "s", "--size", "64x48", "--crop", "-q"}).out,
            viewer::sixel(cropped()) + "\n");
}

TEST_F(ShowTerminal, SeveralImagesStandOneBelowTheOther) {
  const std::string once = viewer::sixel(cropped()) + "\n";
  EXPECT_EQ(show({"s", "--terminal", "--crop"}).out, once + once);
}

TEST_F(ShowTerminal, APngBesideIsTheSame) {
  EXPECT_EQ(show({"--crop", "--png", "alone.png"}).exit_code, 0);
  const Ended both = show({"--crop", "--png", "both.png", "--terminal"});
  EXPECT_EQ(both.out, viewer::sixel(cropped()) + "\n");
  EXPECT_EQ(folder.read("both.png"), folder.read("alone.png"));
}

TEST_F(ShowTerminal, OtherFormsAreWrongUsage) {
  const Ended ended = show({"--terminal=kitty"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--terminal"));
}

TEST_F(ShowTerminal, AFullDiskIsAFailure) {
  Start start;
  start.out_file = "/dev/full";
  expect_failure(sir(words({"--terminal"}), start), "standard output: cannot be written");
}

TEST_F(ShowTerminal, ATerminalWithSixelGetsSixels) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show at";
  AtTerminal terminal(words({"--terminal", "--crop"}), folder.path(), 80);
  const termios before = terminal.modes_at_first();
  ASSERT_TRUE(terminal.wait_for(kQuestion));
  terminal.type("\x1b[?62;4;22c");
  EXPECT_EQ(terminal.finish(), 0);
  EXPECT_EQ(terminal.shown(), kQuestion + viewer::sixel(cropped()) + "\n");
  EXPECT_EQ(terminal.modes().c_lflag, before.c_lflag);
}

TEST_F(ShowTerminal, ATerminalWithoutGetsHalfBlocksOfItsWidth) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show at";
  for (const int columns : {80, 40}) {
    AtTerminal terminal(words({"--terminal=auto", "--crop"}), folder.path(), columns);
    ASSERT_TRUE(terminal.wait_for(kQuestion));
    terminal.type("\x1b[?1;2c");
    EXPECT_EQ(terminal.finish(), 0);
    EXPECT_EQ(terminal.shown(), kQuestion + blocks(columns));
  }
}

TEST_F(ShowTerminal, WhoNamesTheFormIsNotAsked) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show at";
  AtTerminal sixels(words({"--terminal=sixel", "--crop"}), folder.path(), 80);
  EXPECT_EQ(sixels.finish(), 0);
  EXPECT_EQ(sixels.shown(), viewer::sixel(cropped()) + "\n");
  AtTerminal half(words({"--terminal=blocks", "--crop"}), folder.path(), 30);
  EXPECT_EQ(half.finish(), 0);
  EXPECT_EQ(half.shown(), blocks(30));
}

TEST_F(ShowTerminal, ASilentTerminalGetsHalfBlocks) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show at";
  AtTerminal terminal(words({"--terminal", "--crop"}), folder.path(), 80);
  EXPECT_EQ(terminal.finish(), 0);
  EXPECT_EQ(terminal.shown(), kQuestion + blocks(80));
}

TEST_F(ShowTerminal, CtrlCWhileItAsksLeavesTheTerminalAsItWas) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show at";
  for (const bool typed : {true, false}) {
    AtTerminal terminal(words({"--terminal", "--crop"}), folder.path(), 80);
    const termios before = terminal.modes_at_first();
    ASSERT_TRUE(terminal.wait_for(kQuestion));
    if (typed) terminal.type("\x03");
    else terminal.signal(SIGTERM);
    EXPECT_EQ(terminal.finish(), 130);
    EXPECT_THAT(terminal.shown(), Not(HasSubstr("\x1bP")));
    EXPECT_THAT(terminal.shown(), Not(HasSubstr("\u2580")));
    EXPECT_EQ(terminal.modes().c_lflag, before.c_lflag);
  }
}

}  // namespace
}  // namespace sir::test
