#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "eltek/dac.h"
#include "tracer/error.h"
#include "viewer/letterbox.h"
#include "viewer/png_file.h"
#include "viewer/screen_view.h"
#ifdef SIR_WITH_SDL
#include <SDL.h>

#include <cstdlib>
#include <stop_token>
#include <thread>

#include "viewer/window.h"
#endif

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;

ShownImage image(const std::string& name, ImageSize size, unsigned seed) {
  ShownImage shown{name, name + ".LUT", size, std::vector<std::uint8_t>(size.pixels()), {}};
  for (std::size_t i = 0; i < shown.indices.size(); ++i)
    shown.indices[i] = static_cast<std::uint8_t>(i * seed + i / 64);
  for (std::size_t i = 0; i < 256; ++i)
    shown.lut.entry[i] = {static_cast<std::uint8_t>(i * seed % 64),
                          static_cast<std::uint8_t>(i / 4),
                          static_cast<std::uint8_t>((255 - i) % 64)};
  return shown;
}

std::vector<ShownImage> three_images() {
  return {image("A", {64, 48}, 3), image("B", {32, 20}, 5), image("C", {64, 48}, 7)};
}

Rgb8 colour_of(const ShownImage& shown, int column, int row, int mask = 0xFF) {
  const auto index = shown.indices[static_cast<std::size_t>(row * shown.size.width + column)];
  return eltek::dac_colour(shown.lut.entry[static_cast<std::size_t>(index & mask)]);
}

class Folder {
 public:
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  const fs::path path =
      fs::path(testing::TempDir()) / ("window_test-" + std::to_string(::getpid()));
};

TEST(Letterbox, TakesTheLargestWholeMultiple) {
  EXPECT_EQ(largest_multiple({1024, 780}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({2047, 1560}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({2048, 1560}, {1024, 780}), 2);
  EXPECT_EQ(largest_multiple({300, 300}, {1024, 780}), 1);
  EXPECT_EQ(largest_multiple({5000, 5000}, {2, 2}), kMaxMultiple);
}

TEST(Letterbox, CentresAndMayReachBeyondTheWindow) {
  EXPECT_EQ(centre({2100, 1600}, {1024, 780}, 2), (Letterbox{26, 20, 2048, 1560}));
  EXPECT_EQ(centre({1024, 780}, {1024, 780}, 2), (Letterbox{-512, -390, 2048, 1560}));
}

TEST(ScreenView, ShowsTheWholeScreenOrTheImagesArea) {
  const eltek::Screen whole = ScreenView(three_images(), false).picture();
  const eltek::Screen area = ScreenView(three_images(), true).picture();
  EXPECT_EQ(whole.size, (ImageSize{1024, 780}));
  EXPECT_EQ(area.size, (ImageSize{64, 48}));
  const auto shown = image("A", {64, 48}, 3);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      ASSERT_EQ(area.at(column, row), colour_of(shown, column, row));
      ASSERT_EQ(whole.at(480 + column, 366 + row), colour_of(shown, column, row));
    }
}

TEST(ScreenView, GoesRoundTheImagesEachWithItsLut) {
  ScreenView view(three_images(), true);
  EXPECT_EQ(view.title(), "A - LUT A.LUT (1 of 3)");
  view.next();
  EXPECT_EQ(view.title(), "B - LUT B.LUT (2 of 3)");
  EXPECT_EQ(view.picture_size(), (ImageSize{32, 20}));
  EXPECT_EQ(view.picture().at(5, 6), colour_of(image("B", {32, 20}, 5), 5, 6));
  view.next();
  view.next();
  EXPECT_EQ(view.image().base, "A");
  view.previous();
  EXPECT_EQ(view.image().base, "C");
}

TEST(ScreenView, FitsTheDacOfEachImagesLut) {
  std::vector<ShownImage> images = three_images();
  images[1].lut.dac = {{5, 6, 8}};
  for (auto& entry : images[1].lut.entry) entry[0] %= 32;
  ScreenView view(images, true);
  EXPECT_EQ(view.capture().dac, quant::DacBits{});
  view.toggle_plane(7);
  view.next();
  EXPECT_EQ(view.title(), "B - LUT B.LUT, DAC 5,6,8 (2 of 3) - planes 1 2 3 4 5 6 7");
  EXPECT_EQ(view.capture().dac, (quant::DacBits{{5, 6, 8}}));
  const std::size_t index = images[1].indices[6 * 32 + 5] & 0x7F;
  EXPECT_EQ(view.picture().at(5, 6), images[1].lut.seen(index));
  view.next();
  EXPECT_EQ(view.title(), "C - LUT C.LUT (3 of 3) - planes 1 2 3 4 5 6 7");
  EXPECT_EQ(view.picture().at(5, 6), colour_of(images[2], 5, 6, 0x7F));
}

TEST(ScreenView, TheScreenAroundAnImageTakesNoReservedEntry) {
  ShownImage shown = image("A", {64, 48}, 3);
  shown.lut.entry.fill({63, 63, 63});
  shown.lut.entry[5] = {0, 0, 0};
  shown.lut.entry[8] = {9, 9, 9};
  EXPECT_EQ(ScreenView({shown}, false).capture().indices[0], 5);
  shown.reserved.set(5);
  EXPECT_EQ(ScreenView({shown}, false).capture().indices[0], 8);
}

TEST(ScreenView, PlanesGoOffAndStayOffForTheNextImage) {
  ScreenView view(three_images(), true);
  const auto full = view.picture();
  view.toggle_plane(0);
  view.toggle_plane(7);
  EXPECT_EQ(view.planes(), 0b01111110);
  EXPECT_EQ(view.title(), "A - LUT A.LUT (1 of 3) - planes 2 3 4 5 6 7");
  EXPECT_EQ(view.picture().at(9, 9), colour_of(image("A", {64, 48}, 3), 9, 9, 0b01111110));
  view.next();
  EXPECT_EQ(view.picture().at(9, 9), colour_of(image("B", {32, 20}, 5), 9, 9, 0b01111110));
  view.previous();
  view.all_planes();
  EXPECT_EQ(view.picture(), full);
  for (int plane = 0; plane < 8; ++plane) view.toggle_plane(plane);
  EXPECT_EQ(view.title(), "A - LUT A.LUT (1 of 3) - no planes");
}

TEST(ScreenView, SavesTheIndexedScreenAndOverwritesNothing) {
  const Folder folder;
  const ScreenView view({image("some/where/A", {64, 48}, 3)}, false);
  EXPECT_EQ(view.save_capture(folder.path), folder.path / "A-screen.png");
  EXPECT_EQ(view.save_capture(folder.path), folder.path / "A-screen-2.png");
  EXPECT_EQ(read_png(folder.path / "A-screen-2.png"), to_planes(view.picture()));
  EXPECT_THROW(view.save_capture(folder.path / "none"), FileError);
}

TEST(ScreenView, RefusesWhatDoesNotFitAtOnce) {
  std::vector<ShownImage> images = three_images();
  images.push_back(image("LARGE", {1030, 20}, 3));
  EXPECT_THROW(ScreenView(images, false), FileError);
  EXPECT_THROW(ScreenView({}, false), std::invalid_argument);
  ScreenView cut(images, true);
  cut.previous();
  EXPECT_EQ(cut.picture_size(), (ImageSize{1024, 20}));
  EXPECT_EQ(cut.picture().at(0, 0), colour_of(images[3], 3, 0));
}

#ifdef SIR_WITH_SDL

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "dummy", 1);
    options_.image_area_only = true;
    options_.screenshots = folder_.path;
    options_.report = [this](const std::string& text) { reports_.push_back(text); };
  }

  static void press(SDL_Keycode key, Uint16 modifiers = KMOD_NONE, Uint8 repeat = 0) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.state = SDL_PRESSED;
    event.key.repeat = repeat;
    event.key.keysym.sym = key;
    event.key.keysym.mod = modifiers;
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }

  // The keys one after the other, then Q, which ends run().
  static void type(Window& window, std::initializer_list<SDL_Keycode> keys) {
    for (const SDL_Keycode key : keys) press(key);
    press(SDLK_q);
    window.run();
  }

  // Every pixel of the window is the picture's at a multiple, centred on black.
  static void expect_letterboxed(Window& window, int multiple) {
    const eltek::Screen seen = window.pixels(), picture = window.view().picture();
    const Letterbox box = centre(seen.size, picture.size, multiple);
    for (int y = 0; y < seen.size.height; ++y)
      for (int x = 0; x < seen.size.width; ++x) {
        const bool inside =
            x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
        const Rgb8 expected =
            inside ? picture.at((x - box.x) / multiple, (y - box.y) / multiple) : Rgb8{};
        ASSERT_EQ(seen.at(x, y), expected) << x << "," << y;
      }
  }

  Folder folder_;
  WindowOptions options_;
  std::vector<std::string> reports_;
};

TEST_F(WindowTest, ShowsTheScreenPixelForPixel) {
  options_.image_area_only = false;
  Window window(three_images(), options_);
  EXPECT_EQ(window.multiple(), 1);
  EXPECT_EQ(window.title(), "A - LUT A.LUT (1 of 3) - 1x");
  expect_letterboxed(window, 1);
}

TEST_F(WindowTest, EscapeQAndTheCloseButtonEndIt) {
  for (const SDL_Keycode key : {SDLK_ESCAPE, SDLK_q}) {
    Window window(three_images(), options_);
    press(key);
    window.run();
  }
  Window window(three_images(), options_);
  SDL_Event event{};
  event.type = SDL_QUIT;
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  window.run();
  EXPECT_EQ(window.view().image().base, "A");
}

TEST_F(WindowTest, AStopFromAnotherThreadEndsIt) {
  Window window(three_images(), options_);
  std::stop_source source;
  std::jthread elsewhere([&] { source.request_stop(); });
  window.run(source.get_token());
  EXPECT_TRUE(source.stop_requested());
}

TEST_F(WindowTest, ArrowsAndPageKeysTurnThePages) {
  for (const SDL_Keycode key : {SDLK_RIGHT, SDLK_DOWN, SDLK_PAGEDOWN}) {
    Window window(three_images(), options_);
    type(window, {key});
    EXPECT_EQ(window.view().image().base, "B");
    expect_letterboxed(window, window.multiple());  // another size: a new texture
    EXPECT_EQ(window.title().find("B - LUT B.LUT (2 of 3)"), 0u);
  }
  for (const SDL_Keycode key : {SDLK_LEFT, SDLK_UP, SDLK_PAGEUP}) {
    Window window(three_images(), options_);
    type(window, {key});
    EXPECT_EQ(window.view().image().base, "C");
    expect_letterboxed(window, window.multiple());
  }
}

TEST_F(WindowTest, DigitsTogglePlanesAndZeroBringsThemBack) {
  {
    Window window(three_images(), options_);
    type(window, {SDLK_1, SDLK_3, SDLK_8, SDLK_3, SDLK_KP_2, SDLK_9});
    EXPECT_EQ(window.view().planes(), 0b01111100);
    expect_letterboxed(window, 1);
  }
  Window window(three_images(), options_);
  type(window, {SDLK_1, SDLK_2, SDLK_0});
  EXPECT_EQ(window.view().planes(), 0xFF);
}

TEST_F(WindowTest, HeldKeysAndCombinationsToggleNothing) {
  Window window(three_images(), options_);
  press(SDLK_1, KMOD_LCTRL);
  press(SDLK_q, KMOD_LALT);
  press(SDLK_2, KMOD_NONE, 1);
  press(SDLK_s, KMOD_NONE, 1);
  type(window, {});
  EXPECT_EQ(window.view().planes(), 0xFF);
  EXPECT_TRUE(fs::is_empty(folder_.path));
}

TEST_F(WindowTest, PlusAndMinusChangeTheMultipleAndTheWindow) {
  Window window(three_images(), options_);
  EXPECT_EQ(window.pixels().size, (ImageSize{64, 48}));
  type(window, {SDLK_PLUS, SDLK_KP_PLUS, SDLK_EQUALS, SDLK_MINUS});
  EXPECT_EQ(window.multiple(), 3);
  EXPECT_EQ(window.pixels().size, (ImageSize{192, 144}));
  EXPECT_NE(window.title().find(" - 3x"), std::string::npos) << window.title();
  expect_letterboxed(window, 3);
}

TEST_F(WindowTest, MultiplesStayWithinBounds) {
  Window small({image("A", {8, 8}, 3)}, options_);
  type(small, {SDLK_MINUS, SDLK_KP_MINUS});
  EXPECT_EQ(small.multiple(), 1);
  Window large({image("A", {8, 8}, 3)}, options_);
  for (int i = 0; i < 30; ++i) press(SDLK_PLUS);
  type(large, {});
  EXPECT_EQ(large.multiple(), kMaxMultiple);
}

// The environment's wish for smooth scaling must not reach the pixels.
TEST_F(WindowTest, ScalingIsNearestWhateverTheEnvironmentWants) {
  ::setenv("SDL_RENDER_SCALE_QUALITY", "linear", 1);
  Window window(three_images(), options_);
  type(window, {SDLK_PLUS});
  expect_letterboxed(window, 2);
  ::unsetenv("SDL_RENDER_SCALE_QUALITY");
}

TEST_F(WindowTest, AResizedWindowIsLetterboxed) {
  Window window(three_images(), options_);
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 301, 155);
  type(window, {});
  EXPECT_EQ(window.pixels().size, (ImageSize{301, 155}));
  EXPECT_EQ(window.multiple(), 3);
  EXPECT_NE(window.title().find(" - 3x"), std::string::npos) << window.title();
  expect_letterboxed(window, 3);
}

TEST_F(WindowTest, AChosenMultipleStaysUntilF) {
  Window window(three_images(), options_);
  type(window, {SDLK_PLUS, SDLK_PLUS});
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 100, 100);
  EXPECT_EQ(window.multiple(), 3);
  expect_letterboxed(window, 3);  // its centre
}

TEST_F(WindowTest, FTakesTheLargestMultipleThatFits) {
  Window window(three_images(), options_);
  type(window, {SDLK_PLUS, SDLK_PLUS, SDLK_f});
  SDL_SetWindowSize(SDL_GetWindowFromID(1), 130, 100);
  EXPECT_EQ(window.multiple(), 2);
  expect_letterboxed(window, 2);
}

TEST_F(WindowTest, SSavesTheIndexedScreen) {
  Window window(three_images(), options_);
  type(window, {SDLK_4, SDLK_s, SDLK_RIGHT, SDLK_s});
  ASSERT_EQ(reports_.size(), 2u);
  EXPECT_EQ(reports_[0], "saved " + (folder_.path / "A-screen.png").string());
  EXPECT_EQ(read_png(folder_.path / "B-screen.png"), to_planes(window.view().picture()));
  EXPECT_EQ(read_png(folder_.path / "A-screen.png").at(70),
            colour_of(image("A", {64, 48}, 3), 6, 1, 0b11110111));
}

TEST_F(WindowTest, AScreenshotThatCannotBeWrittenClosesNothing) {
  options_.screenshots = folder_.path / "none";
  Window window(three_images(), options_);
  type(window, {SDLK_s, SDLK_RIGHT});
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_NE(reports_[0].find("cannot be written"), std::string::npos) << reports_[0];
  EXPECT_EQ(window.view().image().base, "B");
}

TEST_F(WindowTest, WithoutADisplayItSaysSo) {
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(name);
  ::setenv("XDG_RUNTIME_DIR", folder_.path.c_str(), 1);  // where a compositor would be
  try {
    Window window(three_images(), options_);
    if (fs::exists("/dev/dri")) GTEST_SKIP() << "SDL has the console's display";
    FAIL() << "SDL opened a window that nobody sees";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("no display"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("--png"), std::string::npos) << error.what();
  }
  EXPECT_EQ(SDL_WasInit(SDL_INIT_VIDEO), 0u);
}

#endif  // SIR_WITH_SDL

}  // namespace
}  // namespace sir::viewer
