#include <gmock/gmock.h>

#include "quant/choose.h"
#include "quant/shown_through.h"
#include "viewer/screenshot.h"
#include "viewer_fixture.h"

namespace sir::viewer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// How a made picture looks by one of the thesis's methods.
Planes by_method(ImageSize size, unsigned seed, quant::Method method, quant::Space space) {
  quant::ChooseOptions options;
  options.method = method;
  options.space = space;
  const Planes picture = test::made_picture(size, seed);
  return quant::shown_through(picture, quant::choose_lut(picture, options));
}

TEST_F(ViewerTest, ShowsThePictureThroughTheLutOfItsFile) {
  Viewer& viewer = three();
  EXPECT_EQ(viewer.picture().size, kLarge);
  for (int row = 0; row < kLarge.height; ++row)
    for (int column = 0; column < kLarge.width; ++column)
      ASSERT_EQ(seen(column, row), test::shown_colour(kLarge, 3, column, row));
  EXPECT_EQ(viewer.title(), "A - LUT A.LUT (1 of 3) - 10x");
}

TEST_F(ViewerTest, GoesRoundThePicturesEachWithItsLut) {
  Viewer& viewer = three();
  type({"Page Down"});
  EXPECT_EQ(viewer.picture().size, kSmall);
  EXPECT_EQ(seen(5, 6), test::shown_colour(kSmall, 5, 5, 6));
  EXPECT_THAT(viewer.title(), StartsWith("B - LUT B.LUT (2 of 3)"));
  type({"Right", "Down"});
  EXPECT_THAT(viewer.title(), StartsWith("A - LUT A.LUT (1 of 3)"));
  type({"Page Up"});
  EXPECT_THAT(viewer.title(), StartsWith("C - LUT C.LUT (3 of 3)"));
  EXPECT_EQ(seen(5, 6), test::shown_colour(kLarge, 7, 5, 6));
}

TEST_F(ViewerTest, MethodsByKey) {
  Viewer& viewer = three();
  const struct {
    const char* key;
    quant::Method method;
    quant::Space space;
    const char* title;
  } kCases[] = {
      {"R", quant::Method::median, quant::Space::rgb, "LUT chosen by median in rgb"},
      {"Shift+R", quant::Method::frequency, quant::Space::rgb, "LUT chosen by frequency in rgb"},
      {"H", quant::Method::median, quant::Space::hsv, "LUT chosen by median in hsv"},
      {"Shift+H", quant::Method::frequency, quant::Space::hsv, "LUT chosen by frequency in hsv"},
  };
  for (const auto& [key, method, space, title] : kCases) {
    type({key});
    EXPECT_THAT(viewer.title(), HasSubstr(title));
    EXPECT_EQ(to_planes(viewer.picture()), by_method(kLarge, 3, method, space)) << key;
  }
  type({"B"});
  EXPECT_THAT(viewer.title(), HasSubstr("best"));
  type({"T"});
  EXPECT_THAT(viewer.title(), HasSubstr("true colour"));
  EXPECT_EQ(to_planes(viewer.picture()), test::made_picture(kLarge, 3));
  type({"L"});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));
}

TEST_F(ViewerTest, TheMethodStaysForTheNextPicture) {
  three();
  type({"R", "Page Down"});
  EXPECT_THAT(viewer_->title(), StartsWith("B - LUT chosen by median in rgb"));
}

TEST_F(ViewerTest, ALutFileThatIsNotThereIsSaid) {
  three();
  type({"L"});
  std::filesystem::remove(folder_ / "A.LUT");
  EXPECT_TRUE(test::eventually([&] {
    viewer_->refresh();
    return viewer_->message().find("A.LUT") != std::string::npos;
  })) << viewer_->message();
  ASSERT_FALSE(reports_.empty());
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));  // the last picture stays
}

TEST_F(ViewerTest, PlanesGoOffAndStayOffForTheNextPicture) {
  three();
  type({"1", "8"});
  EXPECT_EQ(viewer_->planes(), 0b01111110);
  EXPECT_THAT(viewer_->title(), HasSubstr(" - planes 2 3 4 5 6 7 - "));
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9, 0b01111110));
  type({"Page Down"});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kSmall, 5, 9, 9, 0b01111110));
  type({"0", "Page Up"});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));
  type({"1", "2", "3", "4", "5", "6", "7", "8"});
  EXPECT_THAT(viewer_->title(), HasSubstr(" - no planes - "));
}

TEST_F(ViewerTest, MLiftsTheReadMaskAndPutsItBack) {
  three();
  type({"1", "2", "M"});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));
  EXPECT_THAT(viewer_->title(), HasSubstr("read mask lifted"));
  type({"M"});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9, 0b11111100));
}

TEST_F(ViewerTest, HeldSpaceOrRightButtonShowsTheReference) {
  three();
  const Rgb8 reference = test::made_picture(kLarge, 3).at(9 * 64 + 9);
  ASSERT_NE(seen(9, 9), reference);
  viewer_->press(*parse_key("Space"));
  EXPECT_TRUE(viewer_->shows_reference());
  EXPECT_EQ(seen(9, 9), reference);
  viewer_->press(*parse_key("Space"));  // a held key comes again and again
  EXPECT_EQ(seen(9, 9), reference);
  viewer_->release(*parse_key("Space"));
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));
  viewer_->press(Button::right, {1, 1});
  EXPECT_EQ(seen(9, 9), reference);
  viewer_->release(Button::right, {1, 1});
  EXPECT_EQ(seen(9, 9), test::shown_colour(kLarge, 3, 9, 9));
}

TEST_F(ViewerTest, ADuelHasTwoMethodsSideBySide) {
  Viewer& viewer = three();
  type({"H", "V"});
  EXPECT_TRUE(viewer.duel());
  EXPECT_EQ(viewer.split_column(), 32);
  const Planes left = by_method(kLarge, 3, quant::Method::median, quant::Space::hsv);
  const Planes right = by_method(kLarge, 3, quant::Method::median, quant::Space::rgb);
  for (int row = 0; row < kLarge.height; ++row)
    for (int column = 0; column < kLarge.width; ++column)
      ASSERT_EQ(seen(column, row),
                (column < 32 ? left : right).at(static_cast<std::size_t>(row * 64 + column)));
  EXPECT_THAT(viewer.title(), HasSubstr("median in hsv | LUT chosen by median in rgb"));
  // Keys choose for the side that Tab made the active one.
  type({"Tab", "L"});
  EXPECT_EQ(seen(40, 9), test::shown_colour(kLarge, 3, 40, 9));
  EXPECT_EQ(seen(20, 9), left.at(9 * 64 + 20));
  type({"V"});
  EXPECT_EQ(seen(40, 9), left.at(9 * 64 + 40));
  EXPECT_EQ(viewer.active_side(), 0);
}

TEST_F(ViewerTest, TheLineOfADuelIsDragged) {
  Viewer& viewer = three();
  type({"V"});
  const Letterbox box = viewer.viewport().box();
  const auto line = [&](int column) { return Place{box.x + column * 10, box.y + 100}; };
  viewer.press(Button::left, line(32));
  viewer.point(line(10));
  viewer.release(Button::left, line(10));
  EXPECT_EQ(viewer.split_column(), 10);
  EXPECT_FALSE(viewer.pixel_pinned());
  viewer.press(Button::left, line(10));
  viewer.point({-50, 100});
  viewer.release(Button::left, {-50, 100});
  EXPECT_EQ(viewer.split_column(), 0);
}

TEST_F(ViewerTest, MapsLieOverThePicture) {
  Viewer& viewer = three();
  const Frame before = viewer.picture();
  type({"D"});
  EXPECT_EQ(viewer.map(), Map::heat);
  EXPECT_NE(viewer.picture(), before);
  type({"D"});
  EXPECT_EQ(viewer.picture(), before);
  type({"W"});
  EXPECT_EQ(viewer.map(), Map::duel);
  EXPECT_TRUE(viewer.duel());
  EXPECT_FALSE(viewer.tally().empty());
  EXPECT_NE(viewer.picture(), before);
  type({"Esc"});
  EXPECT_TRUE(viewer.tally().empty());
}

TEST_F(ViewerTest, EscClosesOneThingAfterTheOtherAndThenTheWindow) {
  Viewer& viewer = three();
  type({"?", "I"});
  EXPECT_TRUE(viewer.key_sheet_open());
  type({"Esc"});
  EXPECT_FALSE(viewer.key_sheet_open());
  EXPECT_TRUE(viewer.inspector_open());
  type({"Esc"});
  EXPECT_FALSE(viewer.inspector_open());
  EXPECT_FALSE(viewer.closed());
  type({"Esc"});
  EXPECT_TRUE(viewer.closed());
}

TEST_F(ViewerTest, TheImagesAreaOrTheWholeScreen) {
  three();
  type({"A"});
  EXPECT_EQ(viewer_->picture().size, eltek::Ma120::kSize);
  EXPECT_EQ(seen(480 + 5, 366 + 6), test::shown_colour(kLarge, 3, 5, 6));
  type({"A"});
  EXPECT_EQ(viewer_->picture().size, kLarge);
}

TEST_F(ViewerTest, ScreenshotsKeepTheLutAndOverwriteNothing) {
  three();
  type({"4", "S", "S"});
  ASSERT_EQ(reports_.size(), 2u);
  EXPECT_EQ(reports_[0], "saved " + (folder_ / "A-screen.png").string());
  EXPECT_EQ(reports_[1], "saved " + (folder_ / "A-screen-2.png").string());
  EXPECT_THAT(viewer_->title(), HasSubstr("saved "));
  const Planes saved = read_png(folder_ / "A-screen.png");
  EXPECT_EQ(saved.at(70), test::shown_colour(kLarge, 3, 6, 1, 0b11110111));
  type({"0", "T", "Shift+S"});
  EXPECT_EQ(read_png(folder_ / "A-seen.png"), test::made_picture(kLarge, 3));
}

TEST_F(ViewerTest, AScreenshotThatCannotBeWrittenClosesNothing) {
  ViewerOptions with = options();
  with.screenshots = folder_ / "none";
  three(with);
  type({"S", "Page Down"});
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_THAT(reports_[0], HasSubstr("cannot be written"));
  EXPECT_THAT(viewer_->title(), StartsWith("B"));
}

TEST_F(ViewerTest, AnEntryOfTheLutStandsOut) {
  Viewer& viewer = three();
  const Rgb8 before = seen(9, 9);
  viewer.point(middle_of({9, 9}));
  type({"E"});
  ASSERT_TRUE(viewer.pinned_entry());
  EXPECT_EQ(seen(9, 9), before);
  int same = 0, dimmed = 0;
  for (int i = 0; i < 64; ++i) {
    const Rgb8 colour = seen(i, 9);
    if (colour == test::shown_colour(kLarge, 3, i, 9)) ++same;
    else ++dimmed;
  }
  EXPECT_GT(dimmed, 0);
  EXPECT_GT(same, 0);
  viewer.hover_entry(static_cast<std::uint8_t>(*viewer.pinned_entry() ^ 1));
  EXPECT_NE(seen(9, 9), before);
  viewer.hover_entry(std::nullopt);
  EXPECT_EQ(seen(9, 9), before);
  type({"E"});
  EXPECT_FALSE(viewer.entry());
}

TEST_F(ViewerTest, ThePaletteOfCommandsDoesWhatItFinds) {
  Viewer& viewer = three();
  type({"Ctrl+P"});
  EXPECT_TRUE(viewer.prompt().open());
  viewer.press(*parse_key("M"));  // as a keyboard sends it: the key, then its character
  viewer.type("m");
  EXPECT_EQ(viewer.prompt().text(), "m");
  viewer.type("edian cut in rgb");
  type({"Enter"});
  EXPECT_FALSE(viewer.prompt().open());
  EXPECT_THAT(viewer.title(), HasSubstr("median in rgb"));
  viewer.type(":");  // wherever the keyboard has it
  EXPECT_TRUE(viewer.prompt().open());
  EXPECT_EQ(viewer.prompt().text(), "");
  type({"Esc"});
  EXPECT_FALSE(viewer.prompt().open());
  EXPECT_FALSE(viewer.closed());
}

TEST_F(ViewerTest, GoesToAPixel) {
  Viewer& viewer = three();
  type({"Ctrl+G"});
  viewer.type("12, 34");
  type({"Enter"});
  EXPECT_EQ(viewer.inspected(), (Place{12, 34}));
  EXPECT_TRUE(viewer.inspector_open());
  type({"Left", "Up", "Shift+Right"});  // with the inspector open, arrows move it
  EXPECT_EQ(viewer.inspected(), (Place{21, 33}));
  for (const char* wrong : {"64, 2", "2, 48", "-1, 0", "nonsense"}) {
    type({"Ctrl+G"});
    viewer.type(wrong);
    type({"Enter"});
    EXPECT_EQ(viewer.inspected(), (Place{21, 33})) << wrong;
    EXPECT_FALSE(viewer.message().empty()) << wrong;
  }
  type({"A", "Ctrl+G"});  // on the whole screen the image's pixels keep their numbers
  viewer.type("0 0");
  type({"Enter"});
  EXPECT_EQ(viewer.inspected(), (Place{480, 366}));
}

TEST_F(ViewerTest, TheInspectorSpeaksOfThePixel) {
  Viewer& viewer = three();
  viewer.point(middle_of({9, 9}));
  type({"I"});
  const std::vector<std::string> lines = viewer.inspection();
  ASSERT_GT(lines.size(), 4u);
  EXPECT_THAT(lines[0], HasSubstr("9,9"));
  viewer.press(Button::left, middle_of({9, 9}));  // a click keeps it there
  viewer.release(Button::left, middle_of({9, 9}));
  viewer.point(middle_of({30, 30}));
  EXPECT_EQ(viewer.inspection(), lines);
}

TEST_F(ViewerTest, TheWheelZoomsAboutTheMouse) {
  Viewer& viewer = three();
  const Place at = middle_of({20, 11});
  viewer.wheel(3, at);
  EXPECT_EQ(viewer.viewport().multiple(), 20);
  EXPECT_EQ(viewer.viewport().pixel_at(at), (Place{20, 11}));
  viewer.press(Button::left, at);
  viewer.point({at.x + 30, at.y});
  viewer.release(Button::left, {at.x + 30, at.y});
  EXPECT_EQ(viewer.viewport().pixel_at({at.x + 30, at.y}), (Place{20, 11}));
  EXPECT_FALSE(viewer.pixel_pinned());  // that was no click
}

TEST_F(ViewerTest, TheTubeIsToldByItsOptions) {
  const auto told = [this](std::optional<eltek::CrtOptions> crt) {
    ViewerOptions with = options();
    with.crt = crt;
    three(with);
    if (viewer_->crt_on()) type({"C"});  // it starts with the tube that it is given
    type({"C"});
    return viewer_->message();
  };
  EXPECT_EQ(told({}), "monitor: a tube (phosphors smpte-c, white d65, gamma 2.2)");
  eltek::CrtOptions crt;
  crt.tube = {eltek::PhosphorSet::p22_h273, eltek::WhitePoint::k9300, 2};
  EXPECT_EQ(told(crt), "monitor: a tube (phosphors p22-h273, white 9300k, gamma 2)");
}

}  // namespace
}  // namespace sir::viewer
