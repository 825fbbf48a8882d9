// The panel of a register trace that is replayed.
#include "eltek/trace_recorder.h"
#include "panel_fixture.h"
#include "viewer/station.h"

namespace sir::viewer {
namespace {

/// A trace of one small image, which is replayed.
class ReplayPanelTest : public PanelTest {
 protected:
  Window& open_trace() {
    eltek::TraceRecorder recorder;
    Station station;
    station.add_listener(recorder);
    Rendition made;
    made.lut = test::made_lut(3);
    for (std::size_t i = 0; i < kSmall.pixels(); ++i)
      made.indices.push_back(static_cast<std::uint8_t>(i));
    station.show("A", kSmall, made);
    window_ = std::make_unique<Window>(std::vector<std::filesystem::path>{}, options());
    window_->viewer().replay(recorder.trace(), "A.trace");
    type(*window_, {SDLK_p});
    return *window_;
  }
  std::size_t at() const { return window_->viewer().player()->position(); }
};

TEST_F(ReplayPanelTest, StepsByItsButtons) {
  Window& window = open_trace();
  const std::size_t all = window.viewer().player()->count();
  ASSERT_GT(all, 200u);
  ASSERT_EQ(at(), all);
  click_text(window, "<");
  EXPECT_EQ(at(), all - 1);
  click_text(window, "<<");
  EXPECT_EQ(at(), all - 101);
  click_text(window, ">");
  EXPECT_EQ(at(), all - 100);
  click_text(window, "|<");
  EXPECT_EQ(at(), 0u);
  click_text(window, ">>");
  EXPECT_EQ(at(), 100u);
  EXPECT_TRUE(says(window, "record 100"));
  click_text(window, ">|");
  EXPECT_EQ(at(), all);
}

TEST_F(ReplayPanelTest, SeeksByItsSlider) {
  Window& window = open_trace();
  const std::size_t all = window.viewer().player()->count();
  const auto slider = test::find_text(window.pixels(), "record " + std::to_string(all));
  ASSERT_TRUE(slider);
  move(slider->x, slider->y);
  button_event(SDL_MOUSEBUTTONDOWN, *slider);  // its text stands in its middle
  window.settle();
  EXPECT_GT(at(), all * 2 / 5);
  EXPECT_LT(at(), all * 3 / 5);
  EXPECT_TRUE(says(window, "record " + std::to_string(at())));
  move(10, slider->y);  // far left, over the picture, which does not move
  window.settle();
  EXPECT_EQ(at(), 0u);
  button_event(SDL_MOUSEBUTTONUP, {10, slider->y});
  move(slider->x, slider->y);
  window.settle();
  EXPECT_EQ(at(), 0u);  // let go
  EXPECT_FALSE(window.viewer().pixel_pinned());
}

}  // namespace
}  // namespace sir::viewer
