// What goes wrong around the viewer: files that change, vanish or do not fit, and commands that
// meet in an unlucky order.
#include <gmock/gmock.h>

#include "viewer/screenshot.h"
#include "viewer_fixture.h"

namespace sir::viewer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(ViewerTest, APictureThatGrowsBeyondTheScreenLeavesTheLastOneAndIsSaid) {
  ViewerOptions with = options();
  with.image_area_only = false;
  three(with);
  viewer_->point({320, 240});
  type({"I"});
  test::write_picture(folder_.path(), "A", {2000, 10}, 3);
  EXPECT_TRUE(test::eventually([&] {
    viewer_->refresh();
    return viewer_->message().find("2000x10") != std::string::npos;
  }));
  settle();
  EXPECT_EQ(viewer_->hopeless(), "");
  EXPECT_EQ(seen(480 + 9, 366 + 40), test::shown_colour(kLarge, 3, 9, 40));
  // The inspector speaks of the picture that is seen.
  type({"Ctrl+G"});
  viewer_->type("9, 40");
  type({"Enter"});
  ASSERT_FALSE(viewer_->inspection().empty());
  EXPECT_THAT(viewer_->inspection()[0], HasSubstr("9,40"));
}

TEST_F(ViewerTest, NothingIsAwaitedOfAPictureThatCannotBeRead) {
  Viewer& viewer = three();
  viewer.press(*parse_key("B"));  // not ready at once
  viewer.open(folder_ / "none.png", true);
  settle();
  EXPECT_THAT(viewer.message(), HasSubstr("none.png"));
  EXPECT_FALSE(viewer.side(0).waiting());
}

TEST_F(ViewerTest, TheWholeScreenOfAPictureThatIsTooLargeEndsNothing) {
  viewer_ = std::make_unique<Viewer>(options());
  viewer_->set_window({640, 480});
  viewer_->open(test::write_picture(folder_.path(), "LARGE", {1030, 20}, 3), true);
  settle();
  type({"A"});
  EXPECT_EQ(viewer_->hopeless(), "");
  EXPECT_THAT(viewer_->message(), HasSubstr("1030x20"));
  type({"A"});
  EXPECT_EQ(seen(0, 0), test::shown_colour({1030, 20}, 3, 3, 0));
}

TEST_F(ViewerTest, APinnedPixelThatASmallerPictureDoesNotHaveIsLetGo) {
  three();
  type({"Ctrl+G"});
  viewer_->type("60 40");
  type({"Enter"});
  test::write_picture(folder_.path(), "A", kSmall, 3);
  EXPECT_TRUE(test::eventually([&] {
    viewer_->refresh();
    return viewer_->picture().size == kSmall;
  }));
  EXPECT_FALSE(viewer_->pixel_pinned());
}

TEST_F(ViewerTest, TheMouseIsOverThePixelThatHasComeUnderIt) {
  three();
  const Place at = middle_of({60, 40});
  viewer_->point(at);
  EXPECT_EQ(viewer_->inspected(), (Place{60, 40}));
  for (const char* key : {"Page Down", "A", "+", "A"}) {
    type({key});
    EXPECT_EQ(viewer_->inspected(), viewer_->viewport().pixel_at(at)) << key;
    type({"E", "E"});
  }
}

TEST_F(ViewerTest, TrueColourOfAPictureWithoutALutFileAfterOneThatHasOne) {
  three();
  std::filesystem::remove(folder_ / "B.LUT");
  type({"T", "Page Down"});
  EXPECT_EQ(viewer_->message(), "");
  EXPECT_THAT(viewer_->title(), StartsWith("B - true colour"));
  EXPECT_EQ(to_planes(viewer_->picture()), test::made_picture(kSmall, 5));
}

TEST_F(ViewerTest, TheReferenceGoesWithItsKeyWhateverElseIsHeldThen) {
  three();
  viewer_->press(*parse_key("Space"));
  viewer_->release(*parse_key("Shift+Space"));
  EXPECT_FALSE(viewer_->shows_reference());
}

TEST_F(ViewerTest, TrueColourWinsNoDuel) {
  Viewer& viewer = three();
  type({"V", "Tab", "T", "W"});
  EXPECT_TRUE(viewer.tally().empty());
  EXPECT_EQ(viewer.map(), Map::none);
  EXPECT_THAT(viewer.message(), HasSubstr("true colour"));
  type({"R", "W"});
  EXPECT_FALSE(viewer.tally().empty());
  type({"V", "T", "D"});  // alone it has no errors either
  EXPECT_EQ(viewer.map(), Map::none);
}

TEST_F(ViewerTest, AsSeenThroughATubeIsWhatIsSeen) {
  ViewerOptions with = options();
  with.crt.emplace().scale = 2;
  three(with);
  type({"T"});
  const Planes reference = to_planes(viewer_->picture());
  EXPECT_NE(reference, test::made_picture(kLarge, 3));  // on the same tube
  type({"Shift+S"});
  EXPECT_EQ(read_png(folder_ / "A-seen.png"), reference);
  viewer_->point(middle_of({9, 9}));
  type({"R", "E"});
  const Planes seen = to_planes(viewer_->picture());
  type({"Shift+S"});
  EXPECT_EQ(read_png(folder_ / "A-seen-2.png"), seen);
}

TEST_F(ViewerTest, APictureLargerThanTheScreenIsRefusedWithBothSizes) {
  ViewerOptions with = options();
  with.image_area_only = false;
  viewer_ = std::make_unique<Viewer>(std::move(with));
  viewer_->open(test::write_picture(folder_.path(), "LARGE", {1030, 20}, 3), false);
  settle();
  EXPECT_THAT(viewer_->hopeless(), HasSubstr("1030x20"));
  EXPECT_THAT(viewer_->hopeless(), HasSubstr("1024x780"));
  viewer_->open(test::write_picture(folder_.path(), "A", kLarge, 3), true);
  settle();
  EXPECT_EQ(viewer_->hopeless(), "");
  EXPECT_EQ(seen(480 + 5, 366 + 6), test::shown_colour(kLarge, 3, 5, 6));
  type({"Page Up", "A"});  // the area alone has its centre
  EXPECT_EQ(viewer_->picture().size, (ImageSize{1024, 20}));
  EXPECT_EQ(seen(0, 0), test::shown_colour({1030, 20}, 3, 3, 0));
}

TEST_F(ViewerTest, AFileThatIsNoPictureIsSaidAndHopelessIfAlone) {
  folder_.write("broken.png", "no picture");
  viewer_ = std::make_unique<Viewer>(options());
  viewer_->open(folder_ / "broken.png", false);
  settle();
  EXPECT_THAT(viewer_->message(), HasSubstr("broken.png"));
  EXPECT_THAT(viewer_->hopeless(), HasSubstr("broken.png"));
  EXPECT_TRUE(reports_.empty());  // whoever ends the window says it, and once is enough
}

TEST_F(ViewerTest, ChangedFilesAreShownAndVanishedOnesKeepTheLastPicture) {
  three();
  for (const unsigned seed : {11u, 13u, 17u}) {
    test::write_picture(folder_.path(), "A", kLarge, seed);
    EXPECT_TRUE(test::eventually([&] {
      viewer_->refresh();
      return seen(9, 9) == test::shown_colour(kLarge, seed, 9, 9) &&
             seen(40, 30) == test::shown_colour(kLarge, seed, 40, 30);
    })) << seed;
  }
  settle();
  std::filesystem::remove(folder_ / "A.png");
  EXPECT_TRUE(test::eventually([&] {
    viewer_->refresh();
    return !viewer_->message().empty();
  }));
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 17, 9, 9));
  EXPECT_THAT(viewer_->message(), HasSubstr("A.png"));
}

}  // namespace
}  // namespace sir::viewer
