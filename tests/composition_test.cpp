// What the viewer composes in one pass by tables is what the definitions say, pixel by pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "viewer_fixture.h"

namespace sir::viewer {
namespace {

class CompositionTest : public ViewerTest {
 protected:
  /// By the definition: scanned out before the LUT, each pixel looked up, the rest laid over.
  Rgb8 expected(int column, int row, const eltek::IndexedScreen& screen,
                const std::array<Rgb8, 256>& palette, const Side& side, const Planes* over,
                bool may_stand_out) const {
    if (const auto image = side.station().image_pixel({column, row}); over != nullptr && image)
      return over->at(static_cast<std::size_t>(image->y * over->size.width + image->x));
    const std::uint8_t index =
        screen.indices[static_cast<std::size_t>(row * screen.size.width + column)];
    const Rgb8 seen = palette[index];
    if (over != nullptr || !may_stand_out || !viewer_->entry() || index == *viewer_->entry())
      return seen;
    const auto grey = static_cast<std::uint8_t>((5 * seen.r + 9 * seen.g + 2 * seen.b) / 48);
    return {grey, grey, grey};
  }

  void expect_by_definition(const std::string& what) {
    const Frame frame = viewer_->picture();
    for (const int which : {0, 1}) {
      const Side& side = viewer_->side(which);
      if (which == 1 && !viewer_->duel()) continue;
      const eltek::IndexedScreen screen = side.station().capture();
      ASSERT_EQ(frame.size, screen.size) << what;
      const auto palette = viewer_->crt_on() ? eltek::Crt{}.palette(screen) : screen.palette;
      const Planes* over = viewer_->findings().map(which);
      Planes truth = side.picture()->planes;
      if (viewer_->crt_on()) {
        eltek::Screen colours{truth.size, {}};
        for (std::size_t i = 0; i < truth.size.pixels(); ++i) colours.pixels.push_back(truth.at(i));
        truth = eltek::to_planes(eltek::Crt{}.show(colours));
      }
      if (viewer_->shows_reference() || side.true_colour()) over = &truth;
      const bool may_stand_out = !viewer_->duel() || viewer_->active_side() == which;
      const int first = which == 1 ? viewer_->split_column() : 0;
      const int end = which == 0 && viewer_->duel() ? viewer_->split_column() : frame.size.width;
      for (int row = 0; row < frame.size.height; ++row)
        for (int column = first; column < end; ++column) {
          const Rgb8 found = rgb(frame.words[frame.offset(column, row)]);
          const Rgb8 wanted = expected(column, row, screen, palette, side, over, may_stand_out);
          if (found != wanted) FAIL() << what << " at " << column << "," << row;
        }
    }
  }
};

TEST_F(CompositionTest, IsWhatTheDefinitionsSay) {
  // One thing after the other, and some together.
  three();
  for (const char* key : {"3", "6", "C", "M", "0", "R", "T", "L", "V", "7", "C", "D", "Tab", "T",
                          "M", "D", "0", "W", "W", "V", "H", "A", "C", "4", "V", "D", "T"}) {
    type({key});
    expect_by_definition(key);
    viewer_->pin_entry(std::uint8_t{77});
    expect_by_definition(std::string(key) + ", an entry");
    viewer_->pin_entry(std::nullopt);
    viewer_->press(Button::right, {1, 1});
    expect_by_definition(std::string(key) + ", reference");
    viewer_->release(Button::right, {1, 1});
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(viewer_->picture().size, eltek::Ma120::kSize);  // by A
}

TEST_F(CompositionTest, TheLineOfADuelMayBeAnywhere) {
  three();
  type({"V"});
  const auto drag = [&](int from, int to) {
    viewer_->press(Button::left, middle_of({from, 20}));
    viewer_->point(middle_of({to, 20}));
    viewer_->release(Button::left, middle_of({to, 20}));
  };
  int at = viewer_->split_column();
  for (const int to : {1, 63, 0, 17}) {
    drag(at, to);
    at = viewer_->split_column();
    expect_by_definition("split at " + std::to_string(at));
  }
}

TEST_F(CompositionTest, ItsVersionGrowsWithItsChangesAlone) {
  three();
  viewer_->picture();
  const auto version = viewer_->picture_version();
  viewer_->point({5, 5});
  viewer_->picture();
  EXPECT_EQ(viewer_->picture_version(), version);
  type({"3"});
  viewer_->picture();
  EXPECT_GT(viewer_->picture_version(), version);
}

}  // namespace
}  // namespace sir::viewer
