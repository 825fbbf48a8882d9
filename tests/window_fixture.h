// A window that nobody sees (SDL's dummy driver), driven by events that the test sends.
#pragma once

#include <SDL.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "temp_folder.h"
#include "viewer/argb.h"
#include "viewer/window.h"
#include "viewer_pictures.h"

namespace sir::viewer {

class WindowTest : public testing::Test {
 protected:
  static constexpr ImageSize kLarge{64, 48}, kSmall{32, 20};

  void SetUp() override {
    ::setenv("SDL_VIDEODRIVER", "dummy", 1);
    inputs_ = {test::write_picture(folder_.path(), "A", kLarge, 3),
               test::write_picture(folder_.path(), "B", kSmall, 5),
               test::write_picture(folder_.path(), "C", kLarge, 7)};
  }

  ViewerOptions options() {
    ViewerOptions options;
    options.image_area_only = true;
    options.screenshots = folder_.path();
    options.report = [this](const std::string& text) { reports_.push_back(text); };
    return options;
  }

  static void send(const SDL_Event& event) {
    SDL_Event copy = event;
    ASSERT_EQ(SDL_PushEvent(&copy), 1);
  }

  static SDL_Event key_event(std::uint32_t type, SDL_Keycode key, Uint16 modifiers, Uint8 repeat) {
    SDL_Event event{};
    event.type = type;
    event.key.state = type == SDL_KEYDOWN ? SDL_PRESSED : SDL_RELEASED;
    event.key.repeat = repeat;
    event.key.keysym.sym = key;
    event.key.keysym.mod = modifiers;
    return event;
  }
  static void press(SDL_Keycode key, Uint16 modifiers = KMOD_NONE, Uint8 repeat = 0) {
    send(key_event(SDL_KEYDOWN, key, modifiers, repeat));
  }

  static void move(int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = x;
    event.motion.y = y;
    send(event);
  }
  static void click(int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEBUTTONDOWN;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.x = x;
    event.button.y = y;
    send(event);
    event.type = SDL_MOUSEBUTTONUP;
    send(event);
  }

  /// The keys one after the other, and all that they ask for done.
  static void type(Window& window, std::initializer_list<SDL_Keycode> keys) {
    for (const SDL_Keycode key : keys) press(key);
    window.settle();
  }

  /// Every pixel of the window is the picture's, where the viewport says, on black.
  static void expect_letterboxed(Window& window, int multiple) {
    const eltek::Screen seen = window.pixels();
    const Frame& picture = window.viewer().picture();
    const Letterbox box = window.viewer().viewport().box();
    ASSERT_EQ(box, centre(seen.size, picture.size, multiple));
    for (int y = 0; y < seen.size.height; ++y)
      for (int x = 0; x < seen.size.width; ++x) {
        const bool inside =
            x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
        Rgb8 expected{};
        if (inside)
          expected =
              rgb(picture.words[picture.offset((x - box.x) / multiple, (y - box.y) / multiple)]);
        ASSERT_EQ(seen.at(x, y), expected) << x << "," << y;
      }
  }

  test::TempFolder folder_;
  std::vector<std::filesystem::path> inputs_;
  std::vector<std::string> reports_;
};

}  // namespace sir::viewer
