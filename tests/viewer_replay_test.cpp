#include <gmock/gmock.h>

#include "eltek/bus.h"
#include "eltek/display_driver.h"
#include "eltek/trace_recorder.h"
#include "viewer/screenshot.h"
#include "viewer_fixture.h"

namespace sir::viewer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ViewerReplayTest : public ViewerTest {
 protected:
  /// Plays the display program with a made picture, settled at its end; `more` follows it.
  Viewer& replay(const std::function<void(eltek::Bus&)>& more = [](eltek::Bus&) {}) {
    const Planes picture = test::made_picture(kLarge, 3);
    std::vector<std::uint8_t> indices;
    for (std::size_t i = 0; i < kLarge.pixels(); ++i)
      indices.push_back(quant::nearest_entry(picture.at(i), test::made_lut(3)));
    eltek::Ma120 machine;
    eltek::Bus bus(machine);
    eltek::TraceRecorder recorder;
    bus.add_listener(recorder);
    eltek::show_image(bus, {"A", kLarge, indices}, test::made_lut(3));
    more(bus);
    viewer_ = std::make_unique<Viewer>(options());
    viewer_->set_window({1024, 780});
    viewer_->replay(recorder.trace(), "A.trace");
    return *viewer_;
  }
};

TEST_F(ViewerReplayTest, ItsTitleSaysWhatIsPlayed) {
  EXPECT_EQ(replay().title(), "A.trace - register trace - 1x");
}

TEST_F(ViewerReplayTest, StepsThroughTheTrace) {
  Viewer& viewer = replay();
  EXPECT_EQ(seen(480 + 5, 366 + 6), test::shown_colour(kLarge, 3, 5, 6));
  const std::size_t all = viewer.player()->count();
  type({"<", ","});
  EXPECT_EQ(viewer.player()->position(), all - 101);
  type({"Home"});
  EXPECT_EQ(seen(480 + 5, 366 + 6), Rgb8{});
  type({",", "."});
  EXPECT_EQ(viewer.player()->position(), 1u);
  EXPECT_THAT(viewer.message(), HasSubstr("1 of " + std::to_string(all) + " records"));
}

TEST_F(ViewerReplayTest, GoesToAPixelOfTheScreen) {
  Viewer& viewer = replay();
  type({"Ctrl+G"});
  viewer.type("485 372");
  type({"Enter"});
  EXPECT_EQ(viewer.inspected(), (Place{485, 372}));
  ASSERT_FALSE(viewer.inspection().empty());
  EXPECT_THAT(viewer.inspection()[0], HasSubstr("485, 372"));
  type({"Ctrl+G"});
  viewer.type("1024 0");
  type({"Enter"});
  EXPECT_THAT(viewer.message(), HasSubstr("columns 0 to 1023 and rows 0 to 779"));
}

TEST_F(ViewerReplayTest, SavesTheFrame) {
  replay();
  type({"S"});
  EXPECT_EQ(read_png(folder_ / "A.trace-screen.png"), to_planes(viewer_->picture()));
  type({"Shift+S"});
  EXPECT_EQ(read_png(folder_ / "A.trace-seen.png"), to_planes(viewer_->picture()));
}

TEST_F(ViewerReplayTest, AFrameOfTwoPalettesIsSavedAsItIsSeen) {
  replay([](eltek::Bus& bus) {
    bus.wait(400);
    bus.write(eltek::Port::blank, 1);
  });
  type({"S"});
  EXPECT_THAT(viewer_->message(), HasSubstr("more than one palette"));
  type({"Shift+S"});
  EXPECT_EQ(read_png(folder_ / "A.trace-seen.png"), to_planes(viewer_->picture()));
}

TEST_F(ViewerReplayTest, WhatNeedsPicturesIsRefused) {
  Viewer& viewer = replay();
  const Frame before = viewer.picture();
  viewer.point(middle_of({490, 370}));
  for (const CommandInfo& info : commands()) {
    if (!needs_pictures(info.command)) continue;
    const auto key = parse_key(info.keys.front());
    ASSERT_TRUE(key);
    viewer.press(*key);
    EXPECT_EQ(viewer.picture(), before) << info.name;
    // Flipping is for as long as its key is held, and then too late to be spoken of.
    if (info.command == Command::flip_reference) EXPECT_FALSE(viewer.shows_reference());
    else EXPECT_THAT(viewer.message(), HasSubstr("register trace")) << info.name;
    viewer.release(*key);
  }
  EXPECT_FALSE(viewer.duel());
  EXPECT_FALSE(viewer.crt_on());
  viewer.open(test::write_picture(folder_.path(), "A", kLarge, 5), true);
  settle();
  EXPECT_THAT(viewer.message(), HasSubstr("register trace"));
  EXPECT_EQ(viewer.picture(), before);
  EXPECT_THAT(viewer.title(), StartsWith("A.trace - register trace"));
}

}  // namespace
}  // namespace sir::viewer
