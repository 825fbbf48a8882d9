// A window with its panel open, and a hand that clicks what it reads.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "panel_text.h"
#include "window_fixture.h"

namespace sir::viewer {

class PanelTest : public WindowTest {
 protected:
  static constexpr ImageSize kTall{300, 740};  // there is room for the panel on 1024 x 768

  void SetUp() override {
    WindowTest::SetUp();
    tall_ = test::write_picture(folder_.path(), "T", kTall, 3);
  }

  /// A window on some pictures with the panel open.
  Window& open(std::vector<std::filesystem::path> inputs) {
    window_ = std::make_unique<Window>(inputs, options());
    window_->settle();
    type(*window_, {SDLK_p});
    return *window_;
  }
  Window& open() { return open({tall_}); }

  static void point(Window& window, Place at) {
    move(at.x, at.y);
    window.settle();
  }

  static void click_at(Window& window, Place at) {
    move(at.x, at.y);
    click(at.x, at.y);
    window.settle();
  }

  /// Clicks what is written so.
  static void click_text(Window& window, std::string_view text, int from_row = 0) {
    const auto place = test::find_label(window.pixels(), text, from_row);
    ASSERT_TRUE(place) << text;
    click_at(window, *place);
  }

  static bool says(Window& window, std::string_view text, Rgb8 ink = test::kPanelInk) {
    return test::find_text(window.pixels(), text, ink).has_value();
  }

  static void wheel(int steps) {
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = steps;
    send(event);
  }

  static void button_event(std::uint32_t type, Place at) {
    SDL_Event event{};
    event.type = type;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.x = at.x;
    event.button.y = at.y;
    send(event);
  }

  static void escape(Window& window) {
    SDL_Event event = key_event(SDL_KEYDOWN, SDLK_ESCAPE, KMOD_NONE, 0);
    event.key.keysym.scancode = SDL_SCANCODE_ESCAPE;
    send(event);
    event.type = SDL_KEYUP;
    send(event);
    window.settle();
  }

  /// Where the LUT's fields are, found by pointing below the choice of their order.
  struct Fields {
    Place first;   ///< its middle
    int side = 0;  ///< from one to the next
    Place at(int i) const { return {first.x + i % 16 * side, first.y + i / 16 * side}; }
  };
  Fields find_fields(Window& window, std::string_view order = "LUT order") {
    const auto label = test::find_text(window.pixels(), order);
    if (!label) {
      ADD_FAILURE() << "the panel has no \"" << order << '"';
      return {};
    }
    const auto search = [&](Place at, int right, int down, auto found) {
      for (int i = 0; i < 100; ++i, at.x += right, at.y += down) {
        point(window, at);
        if (found(window.viewer().entry())) return at;
      }
      ADD_FAILURE() << "no field";
      return at;
    };
    const auto changes = [&](Place from) {
      const auto entry = window.viewer().entry();
      return search(from, 1, 0, [&](auto now) { return now && now != entry; });
    };
    const Place inside =
        search({kTall.width + 12, label->y}, 0, 1, [](auto entry) { return entry.has_value(); });
    // The left edges of the second and of the third.
    const Place second = changes(inside), third = changes(second);
    const int side = third.x - second.x;
    return {{second.x - side / 2, inside.y + side / 2}, side};
  }

  /// How the picture looks while one entry stands out.
  static void expect_standing_out(Window& window, const Frame& plain, std::uint8_t entry) {
    const Frame& seen = window.viewer().picture();
    const auto indices = window.viewer().side(0).station().capture().indices;
    ASSERT_EQ(seen.size, plain.size);
    std::size_t dimmed = 0;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const Rgb8 now = rgb(seen.words[i]), then = rgb(plain.words[i]);
      if (indices[i] == entry) ASSERT_EQ(now, then) << i;
      else ASSERT_TRUE(now.r == now.g && now.g == now.b && now.r <= 85) << i;
      dimmed += indices[i] != entry;
    }
    EXPECT_GT(dimmed, 0u);
    expect_picture_shown(window);
  }

  /// The window's picture is the viewer's, pixel for pixel.
  static void expect_picture_shown(Window& window) {
    const eltek::Screen seen = window.pixels();
    const Frame& picture = window.viewer().picture();
    ASSERT_EQ(window.viewer().viewport().box(),
              (Letterbox{0, 0, picture.size.width, picture.size.height}));
    for (int y = 0; y < picture.size.height; ++y)
      for (int x = 0; x < picture.size.width; ++x)
        ASSERT_EQ(seen.at(x, y), rgb(picture.words[picture.offset(x, y)])) << x << "," << y;
  }

  std::filesystem::path tall_;
  std::unique_ptr<Window> window_;
};

}  // namespace sir::viewer
