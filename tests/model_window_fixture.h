// The modeler's window that nobody sees (SDL's dummy driver), driven by events that the test sends.
#pragma once

#include <SDL.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "tests/temp_folder.h"
#include "viewer/model_window.h"

namespace sir::viewer {

class ModelWindowTest : public testing::Test {
 protected:
  using Spot = ModelWindow::Spot;

  void SetUp() override { ::setenv("SDL_VIDEODRIVER", "dummy", 1); }

  ModelWindow& window() {
    if (!window_) {
      window_ = std::make_unique<ModelWindow>(DeskOptions{}, [this](ModelDesk& desk) {
        for (const std::string& line : lines_) ASSERT_TRUE(desk.execute(line)) << desk.message();
      });
      window_->settle();
    }
    return *window_;
  }
  ModelDesk& desk() { return window().desk(); }

  /// Commands that are done before the window opens.
  void begin_with(std::initializer_list<const char*> lines) {
    lines_.assign(lines.begin(), lines.end());
  }

  static void send(const SDL_Event& event) {
    SDL_Event copy = event;
    ASSERT_EQ(SDL_PushEvent(&copy), 1);
  }
  static void move(Spot at) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = at.x;
    event.motion.y = at.y;
    send(event);
  }
  static void button(std::uint32_t type, Spot at, std::uint8_t which) {
    SDL_Event event{};
    event.type = type;
    event.button.button = which;
    event.button.x = at.x;
    event.button.y = at.y;
    send(event);
  }

  void click(Spot at) {
    move(at);
    button(SDL_MOUSEBUTTONDOWN, at, SDL_BUTTON_LEFT);
    button(SDL_MOUSEBUTTONUP, at, SDL_BUTTON_LEFT);
    window().settle();
  }
  void click(const std::string& label) { click(spot(label)); }

  void drag(Spot from, Spot to, std::uint8_t which = SDL_BUTTON_LEFT) {
    move(from);
    button(SDL_MOUSEBUTTONDOWN, from, which);
    move({(from.x + to.x) / 2, (from.y + to.y) / 2});
    window().settle();
    move(to);
    window().settle();
    button(SDL_MOUSEBUTTONUP, to, which);
    window().settle();
  }

  void press_enter() { key(SDLK_RETURN, SDL_SCANCODE_RETURN); }

  void key(SDL_Keycode sym, SDL_Scancode scancode, Uint16 modifiers = KMOD_NONE) {
    SDL_Event event{};
    for (const std::uint32_t type : {SDL_KEYDOWN, SDL_KEYUP}) {
      event.type = type;
      event.key.keysym.sym = sym;
      event.key.keysym.scancode = scancode;
      event.key.keysym.mod = modifiers;
      send(event);
    }
    if (modifiers != KMOD_NONE) {
      event.key.keysym = {SDL_SCANCODE_LCTRL, SDLK_LCTRL, KMOD_NONE, 0};  // lets go of them
      send(event);
    }
    window().settle();
  }

  /// Letters where the keyboard is, as many at a time as an event of SDL holds.
  void type(const std::string& text) {
    for (const char letter : text) {
      SDL_Event event{};
      event.type = SDL_TEXTINPUT;
      event.text.text[0] = letter;
      send(event);
    }
    window().settle();
  }

  Spot spot(const std::string& label) {
    const auto at = window().find(label);
    EXPECT_TRUE(at.has_value()) << label;
    return at.value_or(Spot{});
  }

  /// A place in the picture, in parts of it.
  Spot in_picture(double right, double down) {
    const Spot corner = spot("picture");
    const ImageSize size = desk().picture_size();
    return {corner.x + static_cast<int>(right * size.width),
            corner.y + static_cast<int>(down * size.height)};
  }

  test::TempFolder folder_;
  std::vector<std::string> lines_;
  std::unique_ptr<ModelWindow> window_;
};

}  // namespace sir::viewer
