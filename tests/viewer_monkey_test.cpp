// A person who tries everything: random keys, mouse and files. What must always hold is checked
// after each.
#include <gmock/gmock.h>

#include <random>

#include "eltek/trace_player.h"
#include "eltek/trace_recorder.h"
#include "viewer_fixture.h"

namespace sir::viewer {
namespace {

class ViewerMonkeyTest : public ViewerTest {
 protected:
  static constexpr std::array kSizes{ImageSize{64, 48},  ImageSize{1, 1},   ImageSize{1024, 780},
                                     ImageSize{1025, 1}, ImageSize{2, 900}, ImageSize{31, 20}};

  std::size_t one_of(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  int between(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  Place somewhere() { return {between(-20, 1100), between(-20, 820)}; }
  ImageSize size() { return kSizes[one_of(kSizes.size())]; }

  void write(const std::string& name) {
    const auto png = test::write_picture(folder_.path(), name, size(), 3);
    quant::Lut lut = test::made_lut(5);
    if (one_of(3) == 0) {
      lut.dac = {{5, 6, 5}};
      for (auto& entry : lut.entry) entry = {1, 2, 3};
      quant::write_lut(folder_ / (name + ".LUT"), lut);
    } else if (one_of(3) == 0) {
      std::filesystem::remove(folder_ / (name + ".LUT"));
    }
    if (one_of(8) == 0) std::filesystem::remove(png);
  }

  void press_a_key() {
    const auto all = commands();
    const CommandInfo& info = all[one_of(all.size())];
    // The window would be gone, folders would fill, and the search for the best takes its time.
    if (info.command == Command::quit || info.command == Command::screenshot ||
        info.command == Command::screenshot_as_seen ||
        (info.command == Command::cancel && !viewer_->inspector_open()) ||
        (info.command == Command::best && one_of(20) > 0))
      return;
    const Key key = *parse_key(info.keys[one_of(info.keys.size())]);
    viewer_->press(key);
    if (one_of(3) > 0) viewer_->release(key);
    if (viewer_->prompt().open() && one_of(2) == 0) {
      viewer_->type(std::to_string(between(-5, 1100)) + " " + std::to_string(between(-5, 800)));
      viewer_->press(*parse_key("Enter"));
    }
  }

  void move_the_mouse() {
    const Button button = static_cast<Button>(one_of(3));
    const Place at = somewhere();
    switch (one_of(5)) {
      case 0: return viewer_->press(button, at);
      case 1: return viewer_->release(button, at);
      case 2: return viewer_->wheel(between(-3, 3), at);
      case 3: return viewer_->set_window({between(1, 1200), between(1, 900)});
      default: return viewer_->point(at);
    }
  }

  void expect_sane() {
    const Frame& frame = viewer_->picture();
    ASSERT_EQ(frame.words.size(), frame.size.pixels());
    ASSERT_EQ(frame.size, viewer_->side(0).station().seen_area().size);
    const Letterbox seen = viewer_->viewport().visible();
    ASSERT_LE(seen.x + seen.width, frame.size.width);
    ASSERT_LE(seen.y + seen.height, frame.size.height);
    if (const auto at = viewer_->inspected()) {
      ASSERT_GE(at->x, 0);
      ASSERT_GE(at->y, 0);
      ASSERT_LT(at->x, frame.size.width);
      ASSERT_LT(at->y, frame.size.height);
    }
    EXPECT_FALSE(viewer_->inspection().empty());
    EXPECT_FALSE(viewer_->title().empty());
    EXPECT_EQ(viewer_->hopeless(), "");
    viewer_->tally();
  }

  static inline std::mt19937 random_;  // goes on where a test is repeated (--gtest_repeat)
};

TEST_F(ViewerMonkeyTest, WhateverIsDoneThePictureIsWholeAndTheTraceGivesIt) {
  eltek::TraceRecorder recorder;
  ViewerOptions with = options();
  with.listener = &recorder;
  three(with);
  for (int i = 0; i < 600 && !viewer_->closed(); ++i) {
    const std::size_t what = one_of(100);
    if (what < 60) press_a_key();
    else if (what < 95) move_the_mouse();
    else if (what < 97) write(std::string(1, "ABC"[one_of(3)]));
    else if (what < 98) viewer_->hover_entry(static_cast<std::uint8_t>(one_of(256)));
    else settle();
    viewer_->refresh();
    ASSERT_NO_FATAL_FAILURE(expect_sane()) << "after " << i + 1 << " things";
  }
  settle();
  ASSERT_FALSE(recorder.full());
  eltek::TracePlayer player(recorder.trace());
  player.seek(player.count());
  const auto replayed = player.raster().capture();
  ASSERT_TRUE(replayed);
  const Station& station = viewer_->side(0).station();
  EXPECT_EQ(crop(*replayed, station.seen_area()), station.capture());
}

}  // namespace
}  // namespace sir::viewer
