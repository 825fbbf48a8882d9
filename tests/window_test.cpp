#include <gmock/gmock.h>

#include <stop_token>
#include <thread>

#include "tracer/error.h"
#include "viewer/letterbox.h"
#include "window_fixture.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(WindowTest, ShowsTheScreenPixelForPixel) {
  ViewerOptions whole = options();
  whole.image_area_only = false;
  Window window(inputs_, whole);
  window.settle();
  EXPECT_EQ(window.title(), "A - LUT A.LUT (1 of 3) - 1x");
  EXPECT_EQ(window.viewer().picture().size, eltek::Ma120::kSize);
  expect_letterboxed(window, 1);
  const Letterbox box = window.viewer().viewport().box();  // the desktop may be too low for it
  EXPECT_EQ(window.pixels().at(box.x + 480 + 5, box.y + 366 + 6),
            test::shown_colour(kLarge, 3, 5, 6));
}

TEST_F(WindowTest, TheFirstPictureDecidesHowLargeItIs) {
  Window window(inputs_, options());
  window.settle();
  EXPECT_EQ(window.pixels().size, kLarge);
  expect_letterboxed(window, 1);
}

TEST_F(WindowTest, EscapeQAndTheCloseButtonEndIt) {
  for (const SDL_Keycode key : {SDLK_ESCAPE, SDLK_q}) {
    Window window(inputs_, options());
    press(key);
    window.run();
    EXPECT_TRUE(window.viewer().closed());
  }
  Window window(inputs_, options());
  SDL_Event event{};
  event.type = SDL_QUIT;
  send(event);
  window.run();
  EXPECT_TRUE(window.viewer().closed());
}

TEST_F(WindowTest, AStopFromAnotherThreadEndsIt) {
  Window window(inputs_, options());
  std::stop_source source;
  std::jthread elsewhere([&] { source.request_stop(); });
  window.run(source.get_token());
  EXPECT_TRUE(source.stop_requested());
}

TEST_F(WindowTest, ArrowsAndPageKeysTurnThePages) {
  for (const SDL_Keycode key : {SDLK_RIGHT, SDLK_DOWN, SDLK_PAGEDOWN}) {
    Window window(inputs_, options());
    type(window, {key});
    EXPECT_THAT(window.title(), StartsWith("B - LUT B.LUT (2 of 3)"));
    expect_letterboxed(window, window.viewer().viewport().multiple());  // a new texture
  }
  for (const SDL_Keycode key : {SDLK_LEFT, SDLK_UP, SDLK_PAGEUP}) {
    Window window(inputs_, options());
    type(window, {key});
    EXPECT_THAT(window.title(), StartsWith("C - LUT C.LUT (3 of 3)"));
    expect_letterboxed(window, window.viewer().viewport().multiple());
  }
}

TEST_F(WindowTest, DigitsTogglePlanesAndZeroBringsThemBack) {
  Window window(inputs_, options());
  type(window, {SDLK_1, SDLK_3, SDLK_8, SDLK_3, SDLK_KP_2, SDLK_9});
  EXPECT_EQ(window.viewer().planes(), 0b01111100);
  expect_letterboxed(window, 1);
  type(window, {SDLK_0});
  EXPECT_EQ(window.viewer().planes(), 0xFF);
}

TEST_F(WindowTest, DigitsCountByWhereTheyLieWhereTheyTypeSomethingElse) {
  Window window(inputs_, options());
  SDL_Event event = key_event(SDL_KEYDOWN, 0xE9, KMOD_NONE, 0);  // é, on the key of 2
  event.key.keysym.scancode = SDL_SCANCODE_2;
  send(event);
  window.settle();
  EXPECT_EQ(window.viewer().planes(), 0b11111101);
}

TEST_F(WindowTest, HeldKeysAndCombinationsToggleNothing) {
  Window window(inputs_, options());
  press(SDLK_2, KMOD_LCTRL);
  press(SDLK_q, KMOD_LALT);
  press(SDLK_q, KMOD_LGUI);
  press(SDLK_2, KMOD_NONE, 1);
  press(SDLK_s, KMOD_NONE, 1);
  type(window, {});
  EXPECT_EQ(window.viewer().planes(), 0xFF);
  EXPECT_FALSE(window.viewer().closed());
  EXPECT_FALSE(folder_.has("A-screen.png"));
}

TEST_F(WindowTest, PlusAndMinusChangeTheMultipleAndTheWindow) {
  Window window(inputs_, options());
  window.settle();
  type(window, {SDLK_PLUS, SDLK_KP_PLUS, SDLK_EQUALS, SDLK_MINUS});
  EXPECT_EQ(window.viewer().viewport().multiple(), 3);
  EXPECT_EQ(window.pixels().size, (ImageSize{192, 144}));
  EXPECT_THAT(window.title(), HasSubstr(" - 3x"));
  expect_letterboxed(window, 3);
}

// The environment's wish for smooth scaling must not reach the pixels.
TEST_F(WindowTest, ScalingIsNearestWhateverTheEnvironmentWants) {
  ::setenv("SDL_RENDER_SCALE_QUALITY", "linear", 1);
  Window window(inputs_, options());
  window.settle();
  type(window, {SDLK_PLUS});
  expect_letterboxed(window, 2);
  ::unsetenv("SDL_RENDER_SCALE_QUALITY");
}

TEST_F(WindowTest, AResizedWindowIsLetterboxed) {
  Window window(inputs_, options());
  window.settle();
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 301, 155);
  type(window, {});
  EXPECT_EQ(window.pixels().size, (ImageSize{301, 155}));
  EXPECT_THAT(window.title(), HasSubstr(" - 3x"));
  expect_letterboxed(window, 3);
}

TEST_F(WindowTest, AChosenMultipleStaysUntilF) {
  Window window(inputs_, options());
  window.settle();
  type(window, {SDLK_PLUS, SDLK_PLUS});
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 100, 100);
  expect_letterboxed(window, 3);  // its centre
  type(window, {SDLK_f});
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 130, 100);
  expect_letterboxed(window, 2);
}

TEST_F(WindowTest, HeldSpaceShowsTheReference) {
  Window window(inputs_, options());
  window.settle();
  const Rgb8 reference = test::made_picture(kLarge, 3).at(9 * 64 + 9);
  type(window, {SDLK_SPACE});
  EXPECT_EQ(window.pixels().at(9, 9), reference);
  send(key_event(SDL_KEYUP, SDLK_SPACE, KMOD_NONE, 0));
  window.settle();
  EXPECT_EQ(window.pixels().at(9, 9), test::shown_colour(kLarge, 3, 9, 9));
}

TEST_F(WindowTest, ADroppedFileIsOpenedAndShown) {
  Window window({inputs_[0]}, options());
  window.settle();
  SDL_Event event{};
  event.type = SDL_DROPFILE;
  event.drop.file = SDL_strdup(inputs_[1].c_str());
  send(event);
  window.settle();
  EXPECT_THAT(window.title(), StartsWith("B - LUT B.LUT (2 of 2)"));
}

TEST_F(WindowTest, CharactersThatNeedOtherKeysElsewhereAreCommandsToo) {
  Window window(inputs_, options());
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  event.text.text[0] = '?';
  send(event);
  window.settle();
  EXPECT_TRUE(window.viewer().key_sheet_open());
  EXPECT_GT(window.pixels().size.width, 0);  // drawn without harm on a window of 64 x 48
}

TEST_F(WindowTest, AHeldCharacterTogglesOnceToo) {
  Window window(inputs_, options());
  window.settle();
  const auto question_mark = [](Uint8 repeat) {
    press(SDLK_SLASH, KMOD_LSHIFT, repeat);
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    event.text.text[0] = '?';
    send(event);
  };
  question_mark(0);
  question_mark(1);
  window.settle();
  EXPECT_TRUE(window.viewer().key_sheet_open());
  question_mark(0);
  window.settle();
  EXPECT_FALSE(window.viewer().key_sheet_open());
}

// Plus is a character of another key on many keyboards.
TEST_F(WindowTest, TheWindowFollowsAZoomByACharacter) {
  Window window(inputs_, options());
  window.settle();
  press(SDLK_EQUALS, KMOD_LSHIFT);
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  event.text.text[0] = '+';
  send(event);
  window.settle();
  EXPECT_EQ(window.viewer().viewport().multiple(), 2);
  EXPECT_EQ(window.pixels().size, (ImageSize{128, 96}));
}

TEST_F(WindowTest, LargePixelsShowTheirValues) {
  Window window(inputs_, options());
  window.settle();
  for (int i = 0; i < 20; ++i) press(SDLK_PLUS);
  window.settle();
  ASSERT_EQ(window.viewer().viewport().multiple(), kMaxMultiple);
  const eltek::Screen with = window.pixels();
  type(window, {SDLK_g});
  const eltek::Screen without = window.pixels();
  const Letterbox seen = window.viewer().viewport().visible();
  // Every pixel that is wholly visible has ink on it, and its own colour between the letters.
  const Letterbox box = window.viewer().viewport().box();
  for (int y = seen.y + 1; y + 1 < seen.y + seen.height; ++y)
    for (int x = seen.x + 1; x + 1 < seen.x + seen.width; ++x) {
      int inked = 0;
      for (int j = 0; j < kMaxMultiple; ++j)
        for (int i = 0; i < kMaxMultiple; ++i) {
          const int wx = box.x + x * kMaxMultiple + i, wy = box.y + y * kMaxMultiple + j;
          if (with.at(wx, wy) != without.at(wx, wy)) ++inked;
        }
      ASSERT_GT(inked, 10) << x << "," << y;
      ASSERT_LT(inked, kMaxMultiple * kMaxMultiple / 2);
    }
}

TEST_F(WindowTest, LettersLeaveNothingBehind) {
  ViewerOptions whole = options();
  whole.image_area_only = false;
  Window window(inputs_, whole);
  window.settle();
  const eltek::Screen plain = window.pixels();
  type(window, {SDLK_i});
  move(100, 100);
  window.settle();
  const eltek::Screen left = window.pixels();
  move(900, 700);
  window.settle();
  EXPECT_NE(window.pixels(), left);  // the inspector is in another corner
  type(window, {SDLK_F1});
  move(100, 100);
  window.settle();
  EXPECT_NE(window.pixels(), left);
  type(window, {SDLK_F1});
  EXPECT_EQ(window.pixels(), left);
  type(window, {SDLK_i});
  EXPECT_EQ(window.pixels(), plain);
}

TEST_F(WindowTest, TexturesThatLostTheirContentAreMadeAnew) {
  Window window(inputs_, options());
  window.settle();
  const eltek::Screen before = window.pixels();
  for (const std::uint32_t type : {SDL_RENDER_TARGETS_RESET, SDL_RENDER_DEVICE_RESET}) {
    SDL_Event event{};
    event.type = type;
    send(event);
    window.settle();
    EXPECT_EQ(window.pixels(), before);
  }
}

TEST_F(WindowTest, ADuelHasALineAndAPictureOnEachSide) {
  ViewerOptions whole = options();
  whole.image_area_only = false;
  Window window(inputs_, whole);
  window.settle();
  type(window, {SDLK_v});
  const eltek::Screen seen = window.pixels();
  EXPECT_EQ(seen.at(512, 400), (Rgb8{242, 242, 242}));  // the line
  const Letterbox box = window.viewer().viewport().box();
  EXPECT_EQ(seen.at(box.x + 480 + 5, box.y + 366 + 6), test::shown_colour(kLarge, 3, 5, 6));
  click(700, 300);
  window.settle();
  EXPECT_EQ(window.viewer().inspected(), (Place{700 - box.x, 300 - box.y}));
}

TEST_F(WindowTest, SSavesTheIndexedScreen) {
  Window window(inputs_, options());
  window.settle();
  type(window, {SDLK_4, SDLK_s, SDLK_RIGHT});
  type(window, {SDLK_s});
  ASSERT_EQ(reports_.size(), 2u);
  EXPECT_EQ(reports_[0], "saved " + (folder_ / "A-screen.png").string());
  EXPECT_TRUE(folder_.has("B-screen.png"));
  EXPECT_EQ(read_png(folder_ / "A-screen.png").at(70),
            test::shown_colour(kLarge, 3, 6, 1, 0b11110111));
}

#ifdef SIR_WITH_IMGUI
TEST_F(WindowTest, APanelThatClosesUnderTheMouseLeavesNoEntryShown) {
  ViewerOptions whole = options();
  whole.image_area_only = false;
  Window window(inputs_, whole);
  window.settle();
  type(window, {SDLK_p});
  window.pixels();
  const int width = window.pixels().size.width;
  int y = 0;
  for (; y < 700 && !window.viewer().entry(); y += 10) {
    move(width - 170, y);
    window.settle();
    window.pixels();
  }
  ASSERT_TRUE(window.viewer().entry());
  type(window, {SDLK_p});
  window.pixels();
  EXPECT_FALSE(window.viewer().entry());

  type(window, {SDLK_p});
  move(width - 170, y - 10);
  window.settle();
  window.pixels();
  window.pixels();
  ASSERT_TRUE(window.viewer().entry());
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_LEAVE;
  send(event);
  window.settle();
  window.pixels();
  EXPECT_FALSE(window.viewer().entry());
}
#endif

TEST_F(WindowTest, WhatCannotBeShownAtAllEndsItWithTheReason) {
  folder_.write("broken.png", "no picture");
  Window window({folder_ / "broken.png"}, options());
  try {
    window.run();
    FAIL() << "an empty window";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("broken.png"));
  }
}

TEST_F(WindowTest, WithoutADisplayItSaysSo) {
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(name);
  ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);  // where a compositor would be
  try {
    Window window(inputs_, options());
    if (fs::exists("/dev/dri")) GTEST_SKIP() << "SDL has the console's display";
    FAIL() << "SDL opened a window that nobody sees";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no display"));
    EXPECT_THAT(error.what(), HasSubstr("--png"));
    EXPECT_THAT(error.what(), HasSubstr("--terminal"));
  }
  EXPECT_EQ(SDL_WasInit(SDL_INIT_VIDEO), 0u);
}

}  // namespace
}  // namespace sir::viewer
