// The window on a real X server: what can be seen on its screen is what the viewer says.
#include <gmock/gmock.h>

#include <atomic>
#include <functional>
#include <stop_token>
#include <thread>

#include "eventually.h"
#include "window_fixture.h"
#include "x_server.h"
#ifdef SIR_WITH_IMGUI
#include "panel_text.h"
#endif

namespace sir::viewer {
namespace {

class XvfbTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    // Room for the MA120's screen twice as large, and the panel.
    server_ = test::XServer::start({2500, 1700});
    if (!server_) GTEST_SKIP() << "no Xvfb (Debian: xvfb): the window is not tried on an X server";
    ::setenv("SDL_VIDEODRIVER", "x11", 1);
    ::setenv("DISPLAY", server_->display().c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("DISPLAY");
    ::unsetenv("SDL_RENDER_DRIVER");
  }

  /// Runs the window while another thread does what a person would and looks at the screen.
  static void run(Window& window, const std::function<void()>& person) {
    std::stop_source source;
    std::jthread other([&] {
      person();
      source.request_stop();
    });
    window.run(source.get_token());
  }

  /// Waits until the window has the picture at a multiple, from its upper left corner on.
  bool shows(const Frame& picture, int multiple) const {
    return test::eventually([&] {
      const eltek::Screen seen = server_->largest_window();
      if (seen.size.width < picture.size.width * multiple ||
          seen.size.height != picture.size.height * multiple)
        return false;
      for (int y = 0; y < picture.size.height * multiple; ++y)
        for (int x = 0; x < picture.size.width * multiple; ++x)
          if (seen.at(x, y) != rgb(picture.words[picture.offset(x / multiple, y / multiple)]))
            return false;
      return true;
    });
  }

  std::unique_ptr<test::XServer> server_;
};

TEST_F(XvfbTest, ThePictureIsThereForEveryPixelAtOneAndTwo) {
  for (const char* renderer : {"", "software"}) {
    if (*renderer != '\0') ::setenv("SDL_RENDER_DRIVER", renderer, 1);
    ViewerOptions whole = options();
    whole.image_area_only = false;
    Window window(inputs_, whole);
    window.settle();
    const Frame picture = window.viewer().picture();
    ASSERT_EQ(picture.size, eltek::Ma120::kSize);
    run(window, [&] {
      EXPECT_TRUE(shows(picture, 1)) << renderer;
      press(SDLK_PLUS);
      EXPECT_TRUE(shows(picture, 2)) << renderer;
      press(SDLK_MINUS);
      EXPECT_TRUE(shows(picture, 1)) << renderer;
    });
    EXPECT_TRUE(window.viewer().closed());
  }
}

TEST_F(XvfbTest, ASwitchedPlaneIsSeenWithoutFurtherEvents) {
  Window window(inputs_, options());
  window.settle();
  const Frame plain = window.viewer().picture();
  type(window, {SDLK_1});
  const Frame without = window.viewer().picture();
  type(window, {SDLK_1});
  ASSERT_NE(plain, without);
  run(window, [&] {
    EXPECT_TRUE(shows(plain, 1));
    press(SDLK_1);
    EXPECT_TRUE(shows(without, 1));
  });
}

#ifdef SIR_WITH_IMGUI
TEST_F(XvfbTest, ThePanelFollowsTheMouseWithoutFurtherEvents) {
  constexpr ImageSize kTall{300, 740};
  Window window({test::write_picture(folder_.path(), "T", kTall, 3)}, options());
  window.settle();
  const Frame plain = window.viewer().picture();
  type(window, {SDLK_p});
  const auto order = test::find_text(window.pixels(), "LUT order");
  ASSERT_TRUE(order);
  const Place field{order->x, order->y + 100};
  move(field.x, field.y);
  window.settle();
  const auto entry = window.viewer().entry();
  ASSERT_TRUE(entry);
  const Frame dimmed = window.viewer().picture();
  ASSERT_NE(dimmed, plain);
  move(1, 1);
  window.settle();
  run(window, [&] {
    EXPECT_TRUE(shows(plain, 1));
    server_->point(field);
    EXPECT_TRUE(shows(dimmed, 1));
    server_->point({20, 20});
    EXPECT_TRUE(shows(plain, 1));
  });
}
#endif

}  // namespace
}  // namespace sir::viewer
