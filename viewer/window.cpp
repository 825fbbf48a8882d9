#include "viewer/window.h"

#include <algorithm>
#include <cstdint>
#include <optional>
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

// A toolkit sees a click in two drawings, and lays out what it opens unseen in a third.
constexpr int kDrawingsAnEvent = 3;

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
    show();
  }

  void run(std::stop_token stop) {
    const std::stop_callback on_stop(std::move(stop), [] { push(SDL_QUIT); });
    while (!viewer_.closed()) {
      if (stale()) handle_waiting();
      else handle_events();
      if (viewer_.closed()) return;
      if (const std::string reason = viewer_.hopeless(); !reason.empty())
        throw FileError::repeated(reason);
      if (!stale()) continue;
      show();
    }
  }

  void settle() {
    handle_waiting();
    // What is drawn in the panel may ask for more.
    while (!viewer_.closed() && (viewer_.busy() || stale()))
      if (viewer_.busy()) handle_events();
      else show();
  }

  Viewer& viewer() { return viewer_; }

  std::string title() const { return SDL_GetWindowTitle(window_.get()); }

  eltek::Screen pixels() {
    draw();
    return read_back(renderer_.get());
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
    if (event.type == SDL_MOUSEMOTION) mouse_ = place(event.motion.x, event.motion.y);
    if (panel_ && viewer_.panel_open()) {
      if (event.type != SDL_USEREVENT) frames_due_ = kDrawingsAnEvent;
      if (panel_->takes(event)) return;
    }
    switch (event.type) {
      case SDL_QUIT: viewer_.perform(Command::quit); break;
      case SDL_KEYDOWN: press(event.key); break;
      case SDL_KEYUP: viewer_.release(key_of(event.key.keysym)); break;
      case SDL_TEXTINPUT: type(event.text.text); break;
      case SDL_MOUSEMOTION: viewer_.point(mouse_); break;
      case SDL_MOUSEBUTTONDOWN:
        if (const auto button = button_of(event.button.button))
          viewer_.press(*button, place(event.button.x, event.button.y));
        break;
      case SDL_MOUSEBUTTONUP:
        if (const auto button = button_of(event.button.button))
          viewer_.release(*button, place(event.button.x, event.button.y));
        break;
      case SDL_MOUSEWHEEL: viewer_.wheel(event.wheel.y, mouse_); break;
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
        if (panel_) panel_->forget();
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
      panel_->reset();
      frames_due_ = kDrawingsAnEvent;
      make_room_for_panel();
    }
  }

  // In pixels.
  int panel_width() const {
    return panel_ && viewer_.panel_open() ? density().pixels_of(panel_->width()) : 0;
  }

  // Where a window may be, in its units; none where its size is the desktop's.
  std::optional<SDL_Rect> room() const {
    const std::uint32_t flags = SDL_GetWindowFlags(window_.get());
    if ((flags & (SDL_WINDOW_MAXIMIZED | SDL_WINDOW_FULLSCREEN)) != 0) return std::nullopt;
    SDL_Rect bounds{};
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    if (display < 0 || SDL_GetDisplayUsableBounds(display, &bounds) != 0) return std::nullopt;
    return bounds;
  }

  // The window takes the picture's size at a multiple, as far as the desktop has room.
  void take_picture_size(int multiple) {
    const auto bounds = room();
    if (!bounds) return;
    const auto wanted = [&](int length, int most) {
      return static_cast<int>(
          std::min<std::int64_t>(density().units_of(std::int64_t{length} * multiple), most));
    };
    const ImageSize size = viewer_.side(0).station().seen_area().size;
    const int panel = viewer_.panel_open() && panel_ ? panel_->width() : 0;
    const int width = wanted(size.width, bounds->w);
    const int with_panel = std::min(width + panel, bounds->w);
    added_for_panel_ = with_panel - width;
    set_size(with_panel, wanted(size.height, bounds->h), *bounds);
  }

  // The panel takes nothing from the picture where the desktop has room for both.
  void make_room_for_panel() {
    const auto bounds = room();
    int width = 0, height = 0;
    SDL_GetWindowSize(window_.get(), &width, &height);
    if (bounds && viewer_.panel_open()) {
      added_for_panel_ = std::max(0, std::min(width + panel_->width(), bounds->w) - width);
      set_size(width + added_for_panel_, height, *bounds);
    } else if (bounds) {
      set_size(std::max(1, width - added_for_panel_), height, *bounds);
    }
    if (!bounds || !viewer_.panel_open()) added_for_panel_ = 0;
  }

  // Within the desktop's edges.
  void set_size(int width, int height, const SDL_Rect& bounds) {
    SDL_SetWindowSize(window_.get(), width, height);
    const auto inside = [](int at, int first, int length, int wanted) {
      return std::max(first, std::min(at, first + length - wanted));
    };
    int x = 0, y = 0;
    SDL_GetWindowPosition(window_.get(), &x, &y);
    SDL_SetWindowPosition(window_.get(), inside(x, bounds.x, bounds.w, width),
                          inside(y, bounds.y, bounds.h, height));
  }

  void show() {
    draw();
    SDL_RenderPresent(renderer_.get());
  }

  void draw() {
    const PixelSize size = pixel_size(renderer_.get());
    viewer_.set_window({std::max(1, size.width - panel_width()), size.height});
    viewer_.set_panel_shown(panel_width() > 0);
    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    check(SDL_RenderClear(renderer_.get()) == 0, "cannot be drawn to");
    glass_.draw(viewer_, density().scale());
    // What a person does in the panel makes the viewer stale again; and what is new in the panel
    // has its place only in the drawing after.
    frames_due_ = std::max(frames_due_, viewer_.stale() && panel_width() > 0 ? 2 : 1) - 1;
    viewer_.drawn();
    if (panel_width() > 0) panel_->draw();
    SDL_SetWindowTitle(window_.get(), viewer_.title().c_str());
  }

  Video video_;
  Owned<SDL_Window> window_;
  Owned<SDL_Renderer> renderer_;
  Glass glass_;
  Viewer viewer_;  // its threads wake the window: it goes first
  std::unique_ptr<Panel> panel_;
  bool sized_ = false, panel_was_open_ = false, held_ = false;
  int added_for_panel_ = 0;  // to the window's width, in its units
  int frames_due_ = 0;
  Place mouse_;
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
