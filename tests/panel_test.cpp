// The panel as a person uses it: reading, pointing, clicking.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <utility>

#include "panel_fixture.h"

namespace sir::viewer {
namespace {

using test::find_text;
using testing::HasSubstr;

TEST_F(PanelTest, OpensBesideThePictureAndTakesNothingFromIt) {
  Window window({tall_}, options());
  window.settle();
  const eltek::Screen before = window.pixels();
  ASSERT_EQ(before.size, kTall);
  type(window, {SDLK_p});
  const eltek::Screen with = window.pixels();
  EXPECT_GT(with.size.width, kTall.width + 200);
  EXPECT_EQ(with.size.height, kTall.height);
  EXPECT_EQ(eltek::crop(with, {0, 0, kTall}), before);
  for (const char* text : {"Colours", "The MA120", "LUT", "True colour", "HSV median"})
    EXPECT_TRUE(find_text(with, text)) << text;
  type(window, {SDLK_p});
  EXPECT_EQ(window.pixels(), before);
}

TEST_F(PanelTest, AResizedWindowGrowsByItTooAndShrinksAgain) {
  Window window(inputs_, options());
  window.settle();
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 333, 222);
  window.settle();
  type(window, {SDLK_p});
  const int panel = window.pixels().size.width - 333;
  EXPECT_GT(panel, 200);
  EXPECT_EQ(window.viewer().viewport().window(), (ImageSize{333, 222}));
  type(window, {SDLK_p});
  EXPECT_EQ(window.pixels().size, (ImageSize{333, 222}));
  // What a person makes wider meanwhile stays wider.
  type(window, {SDLK_p});
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 333 + panel + 50, 222);
  window.settle();
  type(window, {SDLK_p});
  EXPECT_EQ(window.pixels().size, (ImageSize{383, 222}));
}

TEST_F(PanelTest, WhereTheDesktopIsTooNarrowThePictureGivesWay) {
  Window window(inputs_, options());
  window.settle();
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 1000, 300);
  window.settle();
  type(window, {SDLK_p});
  EXPECT_EQ(window.pixels().size, (ImageSize{1024, 300}));
  EXPECT_LT(window.viewer().viewport().window().width, 800);
  type(window, {SDLK_p});
  EXPECT_EQ(window.pixels().size, (ImageSize{1000, 300}));
}

TEST_F(PanelTest, PointingAtAnEntryShowsItsPixelsAndAClickKeepsThem) {
  Window& window = open();
  const Frame plain = window.viewer().picture();
  const Fields fields = find_fields(window);
  const auto& indices = window.viewer().side(0).rendition()->indices;
  const int used = indices[kTall.pixels() / 2];
  point(window, fields.at(used));
  ASSERT_EQ(window.viewer().entry(), used);
  EXPECT_EQ(window.viewer().pinned_entry(), std::nullopt);
  expect_standing_out(window, plain, static_cast<std::uint8_t>(used));
  EXPECT_TRUE(says(window, "entry " + std::to_string(used) + ": codes"));
  const auto pixels = std::count(indices.begin(), indices.end(), used);
  EXPECT_TRUE(says(window, std::to_string(pixels) + " pixels"));

  point(window, {5, 5});
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  EXPECT_EQ(window.viewer().picture(), plain);
  expect_picture_shown(window);

  click_at(window, fields.at(used));
  point(window, {5, 5});
  EXPECT_EQ(window.viewer().entry(), used);
  expect_standing_out(window, plain, static_cast<std::uint8_t>(used));
  const int other = (used + 1) % 256;
  point(window, fields.at(other));
  EXPECT_EQ(window.viewer().entry(), other);
  EXPECT_EQ(window.viewer().pinned_entry(), used);
  click_at(window, fields.at(used));
  point(window, {5, 5});
  EXPECT_EQ(window.viewer().picture(), plain);
}

TEST_F(PanelTest, NothingStandsOutOnceTheMouseOrThePanelIsGone) {
  Window& window = open();
  const Frame plain = window.viewer().picture();
  const Fields fields = find_fields(window);
  point(window, fields.at(3));
  ASSERT_EQ(window.viewer().entry(), 3);
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_LEAVE;
  send(event);
  window.settle();
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  point(window, fields.at(3));
  ASSERT_EQ(window.viewer().entry(), 3);
  type(window, {SDLK_p});
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  EXPECT_EQ(window.viewer().picture(), plain);
  type(window, {SDLK_p});  // the mouse is taken to be there only when it moves
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  point(window, fields.at(3));
  ASSERT_EQ(window.viewer().entry(), 3);
  click_text(window, "LUT", fields.first.y - 80);  // closes that part
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  EXPECT_FALSE(says(window, "LUT order"));
}

TEST_F(PanelTest, AnotherOrderIsAMatterOfTheViewAlone) {
  Window& window = open();
  const Frame plain = window.viewer().picture();
  const auto rendition = window.viewer().side(0).rendition();
  std::string shown = "LUT order";
  for (const auto& [order, name] :
       {std::pair{EntryOrder::pixels, "by pixels"}, std::pair{EntryOrder::hue, "by hue"},
        std::pair{EntryOrder::lightness, "by lightness"},
        std::pair{EntryOrder::index, "LUT order"}}) {
    click_text(window, shown);
    // In the list, which is below what is chosen now.
    const int below = find_text(window.pixels(), shown)->y + 5;
    click_text(window, name, shown == name ? 0 : below);
    shown = name;
    point(window, {5, 5});
    EXPECT_EQ(window.viewer().picture(), plain) << name;
    EXPECT_EQ(window.viewer().side(0).rendition(), rendition);
    const Fields fields = find_fields(window, name);
    const auto expected =
        entry_order(rendition->lut, lut_usage(rendition->lut, rendition->indices), order);
    for (const int i : {0, 1, 100, 255}) {
      point(window, fields.at(i));
      EXPECT_EQ(window.viewer().entry(), expected[static_cast<std::size_t>(i)]) << name << i;
    }
  }
}

TEST_F(PanelTest, PlanesAndMonitorAreSwitched) {
  Window& window = open();
  const Frame plain = window.viewer().picture();
  const int header = find_text(window.pixels(), "The MA120")->y;
  click_text(window, "3", header);
  EXPECT_EQ(window.viewer().planes(), 0b11111011);
  expect_picture_shown(window);
  EXPECT_NE(window.viewer().picture(), plain);
  click_text(window, "8", header);
  EXPECT_EQ(window.viewer().planes(), 0b01111011);
  click_text(window, "Lift mask");
  EXPECT_EQ(window.viewer().picture(), plain);
  click_text(window, "All planes");
  EXPECT_EQ(window.viewer().planes(), 0xFF);
  EXPECT_EQ(window.viewer().picture(), plain);
  click_text(window, "CRT");
  EXPECT_TRUE(window.viewer().crt_on());
  EXPECT_NE(window.viewer().picture(), plain);
  click_text(window, "CRT");
  EXPECT_EQ(window.viewer().picture(), plain);
}

TEST_F(PanelTest, MethodsAreChosenByTheirButtons) {
  Window& window = open();
  for (const auto& [label, method] :
       {std::pair{"RGB median", Method::rgb_median},
        std::pair{"RGB frequency", Method::rgb_frequency},
        std::pair{"HSV median", Method::hsv_median},
        std::pair{"HSV frequency", Method::hsv_frequency},
        std::pair{"True colour", Method::true_colour}, std::pair{"LUT file", Method::lut_file}}) {
    click_text(window, label);
    EXPECT_EQ(window.viewer().side(0).shown_method(), method);
  }
  click_text(window, "Duel");
  EXPECT_TRUE(window.viewer().duel());
  click_text(window, "Side A");
  EXPECT_EQ(window.viewer().active_side(), 1);
  click_text(window, "HSV median");
  EXPECT_EQ(window.viewer().side(1).shown_method(), Method::hsv_median);
  EXPECT_EQ(window.viewer().side(0).shown_method(), Method::lut_file);
  click_text(window, "Who wins");
  EXPECT_EQ(window.viewer().map(), Map::duel);
  click_text(window, "Duel");
  click_text(window, "Heat map");
  EXPECT_EQ(window.viewer().map(), Map::heat);
}

TEST_F(PanelTest, JudgesAndCounts) {
  Window& window = open();
  click_text(window, "LUT", find_text(window.pixels(), "LUT order")->y - 30);  // closed: room
  EXPECT_TRUE(says(window, "PSNR "));
  EXPECT_TRUE(says(window, "as seen"));
  EXPECT_FALSE(says(window, "judging ...", test::kPanelFaint));
  const eltek::Screen green = window.pixels();
  click_text(window, "red");
  point(window, {5, 5});
  EXPECT_NE(window.pixels(), green);
  click_text(window, "True colour");
  EXPECT_TRUE(says(window, "the reference itself", test::kPanelFaint));
  point(window, {7, 9});
  EXPECT_THAT(window.viewer().inspection().front(), HasSubstr("7,9"));
}

// 300 frequent greens and blues leave no entry for a red ball; HSV keeps one for each hue.
TEST_F(PanelTest, AlarmsWhereAHueIsLost) {
  Planes picture(kTall);
  for (std::size_t i = 0; i < kTall.pixels(); ++i) {
    const std::size_t x = i % 300, y = i / 300;
    const auto level = [](std::size_t at) { return static_cast<std::uint8_t>(at % 20 * 12); };
    picture.set(i, {0, level(x / 15), level(y / 37)});
    if (x < 20 && y < 20) picture.set(i, {250, 10, 10});
  }
  const auto path = folder_ / "hues.png";
  write_rgb_png(path, picture);
  Window& window = open({path});
  click_text(window, "RGB frequency");
  click_text(window, "LUT", find_text(window.pixels(), "LUT order")->y - 30);
  EXPECT_TRUE(says(window, "HUES LOST: red (0", test::kPanelAlarm));
  click_text(window, "HSV median");
  EXPECT_FALSE(says(window, "HUES LOST", test::kPanelAlarm));
  EXPECT_TRUE(says(window, "PSNR "));
}

TEST_F(PanelTest, TheWheelTurnsThePanelOrThePicture) {
  Window& window = open();
  const int before = find_text(window.pixels(), "LUT order")->y;
  point(window, {kTall.width + 100, 600});
  wheel(-1);
  window.settle();
  EXPECT_EQ(window.viewer().viewport().multiple(), 1);
  EXPECT_LT(find_text(window.pixels(), "LUT order")->y, before);
  point(window, {100, 600});
  wheel(1);
  window.settle();
  EXPECT_EQ(window.viewer().viewport().multiple(), 2);
  // About the place that is pointed at.
  EXPECT_EQ(window.viewer().viewport().pixel_at({100, 600}), (Place{100, 600}));
}

TEST_F(PanelTest, ADragStaysWhereItBegan) {
  Window& window = open();
  type(window, {SDLK_PLUS, SDLK_PLUS});
  const auto corner = [&] { return window.viewer().viewport().visible(); };
  const int width = window.viewer().viewport().window().width;
  const Letterbox before = corner();
  move(50, 50);
  button_event(SDL_MOUSEBUTTONDOWN, {50, 50});
  move(width + 60, 50);  // over the panel
  window.settle();
  EXPECT_NE(corner(), before);
  EXPECT_EQ(window.viewer().entry(), std::nullopt);
  button_event(SDL_MOUSEBUTTONUP, {width + 60, 50});
  move(width + 90, 70);
  const Letterbox after = corner();
  window.settle();
  EXPECT_EQ(corner(), after);  // it has ended
  EXPECT_FALSE(window.viewer().pixel_pinned());

  // And the other way round.
  button_event(SDL_MOUSEBUTTONDOWN, {width + 90, 70});
  move(50, 50);
  button_event(SDL_MOUSEBUTTONUP, {50, 50});
  window.settle();
  EXPECT_EQ(corner(), after);
  EXPECT_FALSE(window.viewer().pixel_pinned());
  click(50, 50);
  window.settle();
  EXPECT_TRUE(window.viewer().pixel_pinned());
}

TEST_F(PanelTest, KeysReachTheViewer) {
  Window& window = open({tall_, inputs_[1]});
  point(window, {kTall.width + 100, 100});
  type(window, {SDLK_3});
  EXPECT_EQ(window.viewer().planes(), 0b11111011);
  type(window, {SDLK_RIGHT});
  EXPECT_EQ(window.viewer().number(), 1u);
}

TEST_F(PanelTest, EscapeClosesTheListThenThePanelThenTheWindow) {
  Window& window = open();
  click_text(window, "LUT order");
  ASSERT_TRUE(says(window, "by hue"));
  escape(window);
  EXPECT_FALSE(says(window, "by hue"));
  EXPECT_TRUE(window.viewer().panel_open());
  escape(window);
  EXPECT_FALSE(window.viewer().panel_open());
  EXPECT_FALSE(window.viewer().closed());
  escape(window);
  EXPECT_TRUE(window.viewer().closed());
}

}  // namespace
}  // namespace sir::viewer
