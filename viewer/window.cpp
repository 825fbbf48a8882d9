#include "viewer/window.h"

#include <SDL.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "tracer/error.h"
#include "viewer/letterbox.h"

namespace sir::viewer {
namespace {

[[noreturn]] void fail(const std::string& reason) { throw FileError("window", 0, reason); }

constexpr const char* kWayOut =
    "; run it on a desktop (DISPLAY or WAYLAND_DISPLAY set), or use --terminal or --png OUT.png";

// SDL's video part for as long as this lives.
class Video {
 public:
  Video() {
    // Ctrl+C stays with the program, the screen saver and compositor with the desktop.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    SDL_SetMainReady();
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
      fail(std::string("there is no display: ") + SDL_GetError() + kWayOut);
    // Without a display SDL takes a driver that shows nothing and reports
    // success; that is right only for one who asked for it by name.
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    const char* asked = SDL_GetHint(SDL_HINT_VIDEODRIVER);
    const bool by_name = asked != nullptr && driver == asked;
    if ((driver == "offscreen" || driver == "dummy") && !by_name) {
      SDL_QuitSubSystem(SDL_INIT_VIDEO);
      fail(std::string("there is no display") + kWayOut);
    }
  }
  ~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
};

struct Free {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
  void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
  void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
template <class Resource>
using Owned = std::unique_ptr<Resource, Free>;

void check(bool worked, const char* what) {
  if (!worked) fail(std::string(what) + ": " + SDL_GetError());
}

std::uint32_t argb(Rgb8 colour) {
  return 0xFF000000u | std::uint32_t{colour.r} << 16 | std::uint32_t{colour.g} << 8 | colour.b;
}

// The digit of a key, by what it types or else by where it lies: on some
// keyboards the row of digits types them only with Shift. -1 for none.
int digit_of(const SDL_Keysym& key) {
  if (key.sym >= SDLK_0 && key.sym <= SDLK_9) return key.sym - SDLK_0;
  if (key.sym == SDLK_KP_0 || key.scancode == SDL_SCANCODE_0) return 0;
  if (key.sym >= SDLK_KP_1 && key.sym <= SDLK_KP_9) return key.sym - SDLK_KP_1 + 1;
  if (key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_9)
    return key.scancode - SDL_SCANCODE_1 + 1;
  return -1;
}

}  // namespace

class Window::Impl {
 public:
  Impl(std::vector<ShownImage> images, WindowOptions options)
      : options_(std::move(options)), view_(std::move(images), options_.image_area_only) {
    const ImageSize size = view_.picture_size();
    window_.reset(SDL_CreateWindow("", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width,
                                   size.height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    check(window_ != nullptr, "cannot be opened");
    renderer_.reset(SDL_CreateRenderer(window_.get(), -1, 0));
    check(renderer_ != nullptr, "cannot be drawn to");
    resize_to(1);
    multiple_ = 0;  // from now on it follows the window
    draw();
    SDL_RenderPresent(renderer_.get());
  }

  void run(std::stop_token stop) {
    // Events may be pushed by any thread; this one wakes the wait.
    const std::stop_callback on_stop(std::move(stop), [] {
      SDL_Event event{};
      event.type = SDL_QUIT;
      SDL_PushEvent(&event);
    });
    while (!closed_) {
      SDL_Event event;
      check(SDL_WaitEvent(&event) != 0, "gets no events");
      // All that waits is handled before one drawing answers to it.
      do handle(event);
      while (!closed_ && SDL_PollEvent(&event) != 0);
      if (closed_ || !stale_) continue;
      draw();
      SDL_RenderPresent(renderer_.get());
    }
  }

  const ScreenView& view() const { return view_; }

  int multiple() const {
    return multiple_ > 0 ? multiple_ : largest_multiple(window_size(), view_.picture_size());
  }

  std::string title() const { return SDL_GetWindowTitle(window_.get()); }

  eltek::Screen pixels() {
    draw();
    eltek::Screen screen{window_size(), {}};
    std::vector<std::uint32_t> words(screen.size.pixels());
    check(SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_ARGB8888, words.data(),
                               4 * screen.size.width) == 0,
          "cannot be read back");
    for (const std::uint32_t word : words)
      screen.pixels.push_back({static_cast<std::uint8_t>(word >> 16),
                               static_cast<std::uint8_t>(word >> 8),
                               static_cast<std::uint8_t>(word)});
    return screen;
  }

 private:
  // In pixels, which on dense displays are finer than window coordinates.
  ImageSize window_size() const {
    ImageSize size{0, 0};
    SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
    return size;
  }

  void handle(const SDL_Event& event) {
    switch (event.type) {
      case SDL_QUIT: closed_ = true; break;
      case SDL_KEYDOWN: press(event.key); break;
      case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_EXPOSED ||
            event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED)
          stale_ = true;
        break;
      case SDL_RENDER_TARGETS_RESET:
      case SDL_RENDER_DEVICE_RESET:
        texture_.reset();  // its content is lost
        stale_ = true;
        break;
      default: break;
    }
  }

  void press(const SDL_KeyboardEvent& key) {
    // Combinations belong to the desktop.
    if ((key.keysym.mod & (KMOD_CTRL | KMOD_LALT | KMOD_GUI)) != 0) return;
    stale_ = true;
    status_.clear();
    switch (key.keysym.sym) {
      case SDLK_ESCAPE:
      case SDLK_q: closed_ = true; return;
      case SDLK_RIGHT:
      case SDLK_DOWN:
      case SDLK_PAGEDOWN: view_.next(); return;
      case SDLK_LEFT:
      case SDLK_UP:
      case SDLK_PAGEUP: view_.previous(); return;
      case SDLK_PLUS:
      case SDLK_EQUALS:  // + without Shift
      case SDLK_KP_PLUS: resize_to(multiple() + 1); return;
      case SDLK_MINUS:
      case SDLK_KP_MINUS: resize_to(multiple() - 1); return;
      case SDLK_f: multiple_ = 0; return;
      default: break;
    }
    if (key.repeat != 0) return;  // a held key toggles, or saves, once
    if (key.keysym.sym == SDLK_s) return save();
    const int digit = digit_of(key.keysym);
    if (digit == 0) view_.all_planes();
    if (digit >= 1 && digit <= 8) view_.toggle_plane(digit - 1);
  }

  // The window takes the picture's new size, as far as the desktop has room.
  void resize_to(int multiple) {
    multiple_ = std::clamp(multiple, 1, kMaxMultiple);
    const std::uint32_t flags = SDL_GetWindowFlags(window_.get());
    if ((flags & (SDL_WINDOW_MAXIMIZED | SDL_WINDOW_FULLSCREEN)) != 0) return;
    SDL_Rect room{};
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    if (display < 0 || SDL_GetDisplayUsableBounds(display, &room) != 0) return;
    int units = 0;
    SDL_GetWindowSize(window_.get(), &units, nullptr);
    const int pixels = std::max(window_size().width, 1);
    const auto in_units = [&](int length) { return length * multiple_ * units / pixels; };
    const ImageSize size = view_.picture_size();
    const int width = std::min(in_units(size.width), room.w);
    const int height = std::min(in_units(size.height), room.h);
    SDL_SetWindowSize(window_.get(), width, height);
    // It must not grow beyond the desktop's edge.
    int x = 0, y = 0;
    SDL_GetWindowPosition(window_.get(), &x, &y);
    SDL_SetWindowPosition(window_.get(), std::clamp(x, room.x, room.x + room.w - width),
                          std::clamp(y, room.y, room.y + room.h - height));
  }

  // The show goes on where a screenshot cannot be written.
  void save() {
    try {
      status_ = "saved " + view_.save_capture(options_.screenshots).string();
    } catch (const FileError& error) {
      status_ = error.what();
    }
    options_.report(status_);
  }

  void draw() {
    const eltek::Screen picture = view_.picture();
    upload(picture);
    const Letterbox box = centre(window_size(), picture.size, multiple());
    const SDL_Rect target{box.x, box.y, box.width, box.height};
    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    check(SDL_RenderClear(renderer_.get()) == 0, "cannot be drawn to");
    check(SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &target) == 0,
          "cannot be drawn to");
    std::string title = view_.title() + " - " + std::to_string(multiple()) + "x";
    if (!status_.empty()) title += " - " + status_;
    SDL_SetWindowTitle(window_.get(), title.c_str());
    stale_ = false;
  }

  void upload(const eltek::Screen& picture) {
    int width = 0, height = 0;
    if (texture_) SDL_QueryTexture(texture_.get(), nullptr, nullptr, &width, &height);
    if (ImageSize{width, height} != picture.size) {
      texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888,
                                       SDL_TEXTUREACCESS_STREAMING, picture.size.width,
                                       picture.size.height));
      check(texture_ != nullptr, "cannot hold the screen");
      // The hint for nearest scaling loses to a variable of the environment.
      SDL_SetTextureScaleMode(texture_.get(), SDL_ScaleModeNearest);
      SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE);
    }
    words_.resize(picture.pixels.size());
    std::transform(picture.pixels.begin(), picture.pixels.end(), words_.begin(), argb);
    check(SDL_UpdateTexture(texture_.get(), nullptr, words_.data(), 4 * picture.size.width) == 0,
          "cannot hold the screen");
  }

  WindowOptions options_;
  ScreenView view_;
  Video video_;
  Owned<SDL_Window> window_;
  Owned<SDL_Renderer> renderer_;
  Owned<SDL_Texture> texture_;
  std::vector<std::uint32_t> words_;
  std::string status_;
  int multiple_ = 0;  // 0: the largest that fits
  bool stale_ = false;
  bool closed_ = false;
};

Window::Window(std::vector<ShownImage> images, WindowOptions options)
    : impl_(std::make_unique<Impl>(std::move(images), std::move(options))) {}

Window::~Window() = default;

void Window::run(std::stop_token stop) { impl_->run(std::move(stop)); }

const ScreenView& Window::view() const { return impl_->view(); }

int Window::multiple() const { return impl_->multiple(); }

std::string Window::title() const { return impl_->title(); }

eltek::Screen Window::pixels() { return impl_->pixels(); }

}  // namespace sir::viewer
