#include "viewer/window.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tracer/error.h"
#include "viewer/argb.h"
#include "viewer/glass.h"
#include "viewer/panel.h"
#include "viewer/pixel_density.h"
#include "viewer/sdl_keys.h"
#include "viewer/sdl_video.h"

namespace sir::viewer {
namespace {

// Wakes the wait for events; any thread may.
void push(std::uint32_t type) {
  SDL_Event event{};
  event.type = type;
  SDL_PushEvent(&event);
}

ViewerOptions waking(ViewerOptions options) {
  options.workshop.wake = [] { push(SDL_USEREVENT); };
  return options;
}

}  // namespace

class Window::Impl {
 public:
  Impl(const std::vector<std::filesystem::path>& inputs, ViewerOptions options)
      : window_(SDL_CreateWindow("SIR", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 eltek::Ma120::kSize.width, eltek::Ma120::kSize.height,
                                 SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI)),
        renderer_(window_ ? SDL_CreateRenderer(window_.get(), -1, 0) : nullptr),
        glass_(renderer_.get()),
        viewer_(waking(std::move(options))) {
    check(window_ != nullptr, "cannot be opened");
    check(renderer_ != nullptr, "cannot be drawn to");
    panel_ = make_panel(window_.get(), renderer_.get(), viewer_);
    for (const auto& input : inputs) viewer_.open(input, false);
    take_picture_size(1);
    draw();
    SDL_RenderPresent(renderer_.get());
  }

  void run(std::stop_token stop) {
    const std::stop_callback on_stop(std::move(stop), [] { push(SDL_QUIT); });
    while (!viewer_.closed()) {
      handle_events();
      if (viewer_.closed()) return;
      if (const std::string reason = viewer_.hopeless(); !reason.empty())
        throw FileError::repeated(reason);
      if (!stale()) continue;
      draw();
      SDL_RenderPresent(renderer_.get());
    }
  }

  void settle() {
    handle_waiting();
    while (!viewer_.closed() && viewer_.busy()) handle_events();
    if (!viewer_.closed() && stale()) draw();
  }

  Viewer& viewer() { return viewer_; }

  std::string title() const { return SDL_GetWindowTitle(window_.get()); }

  eltek::Screen pixels() {
    draw();
    const PixelSize size = pixel_size(renderer_.get());
    eltek::Screen screen{{size.width, size.height}, {}};
    std::vector<std::uint32_t> words(screen.size.pixels());
    check(SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_ARGB8888, words.data(),
                               4 * screen.size.width) == 0,
          "cannot be read back");
    screen.pixels.resize(words.size());
    std::transform(words.begin(), words.end(), screen.pixels.begin(), rgb);
    return screen;
  }

 private:
  bool stale() const { return viewer_.stale() || frames_due_ > 0; }

  // Waits for one and handles all that wait with it, before one drawing answers to them.
  void handle_events() {
    SDL_Event event;
    check(SDL_WaitEvent(&event) != 0, "gets no events");
    handle(event);
    handle_waiting();
  }

  void handle_waiting() {
    SDL_Event event;
    while (!viewer_.closed() && SDL_PollEvent(&event) != 0) handle(event);
    viewer_.refresh();
    follow();
  }

  void handle(const SDL_Event& event) {
    if (panel_ && viewer_.panel_open()) {
      // A toolkit answers to an event in this drawing and in the next.
      if (event.type != SDL_USEREVENT) frames_due_ = 2;
      if (panel_->takes(event)) return;
    }
    switch (event.type) {
      case SDL_QUIT: viewer_.perform(Command::quit); break;
      case SDL_KEYDOWN: press(event.key); break;
      case SDL_KEYUP: viewer_.release(key_of(event.key.keysym)); break;
      case SDL_TEXTINPUT: type(event.text.text); break;
      case SDL_MOUSEMOTION: viewer_.point(place(event.motion.x, event.motion.y)); break;
      case SDL_MOUSEBUTTONDOWN:
        if (const auto button = button_of(event.button.button))
          viewer_.press(*button, place(event.button.x, event.button.y));
        break;
      case SDL_MOUSEBUTTONUP:
        if (const auto button = button_of(event.button.button))
          viewer_.release(*button, place(event.button.x, event.button.y));
        break;
      case SDL_MOUSEWHEEL: {
        int x = 0, y = 0;
        SDL_GetMouseState(&x, &y);
        viewer_.wheel(event.wheel.y, place(x, y));
        break;
      }
      case SDL_DROPFILE:
        viewer_.open(event.drop.file, true);
        SDL_free(event.drop.file);
        break;
      case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_EXPOSED ||
            event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED)
          frames_due_ = std::max(frames_due_, 1);
        break;
      case SDL_RENDER_TARGETS_RESET:
      case SDL_RENDER_DEVICE_RESET:
        glass_.forget();  // its content is lost
        frames_due_ = std::max(frames_due_, 1);
        break;
      default: break;
    }
  }

  void press(const SDL_KeyboardEvent& event) {
    const Key key = key_of(event.keysym);
    const bool super = (event.keysym.mod & KMOD_GUI) != 0;  // belongs to the desktop
    if (key.code == 0 || super) return;
    const auto command = command_for(key);
    held_ = event.repeat != 0;
    if (is_unwanted(command)) return;
    with_window(command, [&] { viewer_.press(key); });
  }

  // Some characters are commands; the event that brings one does not say whether the key is held,
  // the key's own does, just before.
  void type(const char* text) {
    const auto key = parse_key(text);
    const auto command = key ? command_for(*key) : std::nullopt;
    if (is_unwanted(command)) return;
    with_window(command, [&] { viewer_.type(text); });
  }

  // A held key moves and zooms again and again; it toggles, and saves, once.
  bool is_unwanted(std::optional<Command> command) const {
    return held_ && command && !repeats(*command) && !viewer_.prompt().open();
  }

  // The window follows a zoom by keys.
  template <typename Act>
  void with_window(std::optional<Command> command, const Act& act) {
    const int before = viewer_.viewport().multiple();
    act();
    if (command == Command::zoom_in || command == Command::zoom_out ||
        command == Command::actual_size)
      if (viewer_.viewport().multiple() != before) take_picture_size(viewer_.viewport().multiple());
  }

  // Mouse events come in the window's units.
  Place place(int x, int y) const {
    const PixelDensity density = this->density();
    return {density.pixel_at(x), density.pixel_at(y)};
  }

  PixelDensity density() const {
    int units = 0;
    SDL_GetWindowSize(window_.get(), &units, nullptr);
    return {std::max(units, 1), std::max(pixel_size(renderer_.get()).width, 1)};
  }

  // What the viewer decided about the window itself.
  void follow() {
    const bool full = (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
                      SDL_WINDOW_FULLSCREEN_DESKTOP;
    if (full != viewer_.full_screen())
      SDL_SetWindowFullscreen(
          window_.get(), viewer_.full_screen() ? std::uint32_t{SDL_WINDOW_FULLSCREEN_DESKTOP} : 0);
    // The first picture decides how large the window is.
    if (!sized_ && viewer_.side(0).rendition()) {
      sized_ = true;
      take_picture_size(1);
    }
    if (panel_ && viewer_.panel_open() != panel_was_open_) {
      panel_was_open_ = viewer_.panel_open();
      frames_due_ = 2;
      take_picture_size(viewer_.viewport().multiple());
    }
  }

  // In pixels.
  int panel_width() const {
    return panel_ && viewer_.panel_open() ? density().pixels_of(panel_->width()) : 0;
  }

  // The window takes the picture's size at a multiple, as far as the desktop has room.
  void take_picture_size(int multiple) {
    const std::uint32_t flags = SDL_GetWindowFlags(window_.get());
    if ((flags & (SDL_WINDOW_MAXIMIZED | SDL_WINDOW_FULLSCREEN)) != 0) return;
    SDL_Rect room{};
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    if (display < 0 || SDL_GetDisplayUsableBounds(display, &room) != 0) return;
    const ImageSize size = viewer_.side(0).station().seen_area().size;
    const auto wanted = [&](int length, int more) {
      return density().units_of(std::int64_t{length} * multiple + more);
    };
    const int width =
        static_cast<int>(std::min<std::int64_t>(wanted(size.width, panel_width()), room.w));
    const int height = static_cast<int>(std::min<std::int64_t>(wanted(size.height, 0), room.h));
    SDL_SetWindowSize(window_.get(), width, height);
    // It must not grow beyond the desktop's edge.
    int x = 0, y = 0;
    SDL_GetWindowPosition(window_.get(), &x, &y);
    SDL_SetWindowPosition(window_.get(), std::clamp(x, room.x, room.x + room.w - width),
                          std::clamp(y, room.y, room.y + room.h - height));
  }

  void draw() {
    const PixelSize size = pixel_size(renderer_.get());
    viewer_.set_window({std::max(1, size.width - panel_width()), size.height});
    viewer_.set_panel_shown(panel_width() > 0);
    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    check(SDL_RenderClear(renderer_.get()) == 0, "cannot be drawn to");
    glass_.draw(viewer_, density().scale());
    if (panel_ && viewer_.panel_open()) panel_->draw();
    SDL_SetWindowTitle(window_.get(), viewer_.title().c_str());
    frames_due_ = std::max(0, frames_due_ - 1);
    viewer_.drawn();
  }

  Video video_;
  Owned<SDL_Window> window_;
  Owned<SDL_Renderer> renderer_;
  Glass glass_;
  Viewer viewer_;  // its threads wake the window: it goes first
  std::unique_ptr<Panel> panel_;
  bool sized_ = false, panel_was_open_ = false, held_ = false;
  int frames_due_ = 0;
};

Window::Window(const std::vector<std::filesystem::path>& inputs, ViewerOptions options)
    : impl_(std::make_unique<Impl>(inputs, std::move(options))) {}

Window::~Window() = default;

void Window::run(std::stop_token stop) { impl_->run(std::move(stop)); }

void Window::settle() { impl_->settle(); }

const Viewer& Window::viewer() const { return impl_->viewer(); }

Viewer& Window::viewer() { return impl_->viewer(); }

std::string Window::title() const { return impl_->title(); }

eltek::Screen Window::pixels() { return impl_->pixels(); }

}  // namespace sir::viewer
