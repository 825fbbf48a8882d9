#include "viewer/model_window.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "modeler/command_line.h"
#include "viewer/argb.h"
#include "viewer/model_overlay.h"
#include "viewer/model_panel.h"
#include "viewer/model_style.h"
#include "viewer/panel_frame.h"
#include "viewer/sdl_video.h"

namespace sir::viewer {
namespace {

constexpr int kPanelWidth = 430, kWidth = 1280, kHeight = 800;
constexpr int kClick = 3;  // a hand that moves so little between press and release has clicked

void push(std::uint32_t type) {
  SDL_Event event{};
  event.type = type;
  SDL_PushEvent(&event);
}

DeskOptions waking(DeskOptions options) {
  options.wake = [] { push(SDL_USEREVENT); };
  return options;
}

}  // namespace

class ModelWindow::Impl {
 public:
  Impl(DeskOptions options, const std::function<void(ModelDesk&)>& prepare)
      : video_("; run it on a desktop (DISPLAY or WAYLAND_DISPLAY set), or without --window"),
        window_(SDL_CreateWindow("SIR modeler", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                 kWidth, kHeight, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI)),
        renderer_(window_ ? SDL_CreateRenderer(window_.get(), -1, 0) : nullptr),
        desk_(waking(std::move(options))) {
    check(window_ != nullptr, "cannot be opened");
    check(renderer_ != nullptr, "cannot be drawn to");
    frame_ = std::make_unique<PanelFrame>(window_.get(), renderer_.get(), kPanelWidth);
    SDL_RendererInfo about{};
    SDL_GetRendererInfo(renderer_.get(), &about);
    set_model_style(static_cast<float>(density()), (about.flags & SDL_RENDERER_SOFTWARE) == 0);
    prepare(desk_);
    desk_.begin();
    panel_.offer(desk_.kept());
    present();
  }

  void run(std::stop_token stop) {
    const std::stop_callback on_stop(std::move(stop), [this] {
      stopped_ = true;
      push(SDL_USEREVENT);
    });
    while (!desk_.closed() && !stopped_) {
      handle_events();
      if (stale()) present();
    }
  }

  void settle() {
    handle_waiting();
    while (!desk_.closed() && (stale() || desk_.busy())) {
      if (stale()) present();
      else handle_events();
    }
  }

  ModelDesk& desk() { return desk_; }

  std::optional<Spot> find(const std::string& label) const {
    if (label == "picture") {
      const auto [units, pixels] = widths();
      return Spot{place_.x * units / pixels, place_.y * units / pixels};
    }
    const auto spot = panel_.spots().find(label);
    if (spot == panel_.spots().end()) return std::nullopt;
    return Spot{spot->second.first, spot->second.second};
  }

  eltek::Screen pixels() {
    draw();
    return read_back(renderer_.get());
  }

 private:
  bool stale() const { return frames_due_ > 0 || desk_.picture() != drawn_; }

  void handle_events() {
    SDL_Event event;
    check(SDL_WaitEvent(&event) != 0, "gets no events");
    handle(event);
    handle_waiting();
  }

  void handle_waiting() {
    SDL_Event event;
    while (!desk_.closed() && SDL_PollEvent(&event) != 0) handle(event);
    follow();
    desk_.refresh();
  }

  void handle(const SDL_Event& event) {
    // A toolkit answers to an event in this drawing and in the next.
    if (event.type != SDL_USEREVENT) frames_due_ = 2;
    if (event.type == SDL_QUIT) return desk_.close();
    if (event.type == SDL_RENDER_TARGETS_RESET || event.type == SDL_RENDER_DEVICE_RESET) {
      texture_.reset();  // its content is lost
      drawn_.reset();
      frame_->forget();
    }
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE)
      mouse_.reset();
    // Of many motions one after the other the last says it all.
    if (event.type != SDL_MOUSEMOTION) follow();
    // The panel sees the mouse once a drawing: where it was when the button went down or up, and
    // each of the two, has a drawing of its own. So has a key, which may be up again at once.
    const bool turns = event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP;
    if (event.type == SDL_MOUSEBUTTONDOWN) desk_.end_drag();  // another begins
    if (turns && std::exchange(moved_over_, false)) draw();
    moved_over_ = moved_over_ || event.type == SDL_MOUSEMOTION;
    if (frame_->takes(event)) {
      mouse_.reset();
      if (turns || event.type == SDL_KEYDOWN) draw();
      frames_due_ = 2;  // what the panel made of it shows in the next
      return;
    }
    switch (event.type) {
      case SDL_KEYDOWN:
        if (!frame_->list_open()) press(event.key.keysym);
        break;
      case SDL_MOUSEBUTTONDOWN: press(event.button); break;
      case SDL_MOUSEBUTTONUP: release(event.button); break;
      case SDL_MOUSEMOTION:
        mouse_ = {event.motion.x, event.motion.y};
        followed_ = false;
        break;
      case SDL_MOUSEWHEEL: desk_.zoom(event.wheel.y); break;
      default: break;
    }
  }

  // Who takes back, or deletes, what a handle is changing has let go of it.
  void let_go() {
    if (!hand_.holds()) return;
    hand_.release(desk_);
    button_ = 0;
  }

  void press(const SDL_Keysym& key) {
    const bool shift = (key.mod & KMOD_SHIFT) != 0;
    if ((key.mod & KMOD_CTRL) != 0) {
      switch (key.sym) {
        case SDLK_z:
        case SDLK_y:
          let_go();
          desk_.execute(shift || key.sym == SDLK_y ? "redo" : "undo");
          break;
        case SDLK_o: panel_.files().open_scene(); break;
        case SDLK_s:
          if (shift) panel_.files().save_script();
          else panel_.files().save(desk_);
          break;
        default: break;
      }
      return;
    }
    switch (key.sym) {
      case SDLK_f: desk_.frame(); break;
      case SDLK_g: hand_.kind = HandleKind::move; break;
      case SDLK_r: hand_.kind = HandleKind::turn; break;
      case SDLK_s: hand_.kind = HandleKind::scale; break;
      case SDLK_h: hand_.kind.reset(); break;
      case SDLK_ESCAPE:
        let_go();
        desk_.select(std::nullopt);
        break;
      case SDLK_DELETE:
        let_go();
        if (const auto& chosen = desk_.selection(); chosen && chosen->place == 0)
          desk_.execute("delete " + modeler::as_word(chosen->solid));
        break;
      default: break;
    }
  }

  void press(const SDL_MouseButtonEvent& event) {
    if (button_ != 0) return;
    button_ = event.button;
    mouse_ = pressed_ = last_ = {event.x, event.y};
    moved_ = false;
    if (button_ == SDL_BUTTON_LEFT) hand_.press(desk_, in_picture(pressed_));
  }

  // Does what the mouse has moved to.
  void follow() {
    if (std::exchange(followed_, true) || !mouse_) return;
    const Spot at = *mouse_;
    if (button_ == 0 || hand_.holds()) return hand_.move(desk_, in_picture(at));
    moved_ = moved_ || std::abs(at.x - pressed_.x) > kClick || std::abs(at.y - pressed_.y) > kClick;
    if (!moved_) return;
    const glm::dvec2 way = in_picture(at) - in_picture(last_);
    const ImageSize size = desk_.picture_size();
    if (button_ == SDL_BUTTON_LEFT) desk_.turn(way.x / size.height, way.y / size.height);
    else desk_.pan(way.x / size.width, way.y / size.height);
    last_ = at;
  }

  void release(const SDL_MouseButtonEvent& event) {
    if (event.button != button_) return;
    button_ = 0;
    desk_.end_drag();
    mouse_ = {event.x, event.y};
    if (hand_.holds()) return hand_.release(desk_);
    if (moved_ || event.button != SDL_BUTTON_LEFT) return;
    const glm::dvec2 at = in_picture(*mouse_);
    desk_.select_at(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
  }

  // In pixels of the picture, from its top left corner.
  glm::dvec2 in_picture(Spot at) const {
    const double scale = density();
    return {at.x * scale - place_.x, at.y * scale - place_.y};
  }

  double density() const {
    const auto [units, pixels] = widths();
    return double(pixels) / units;
  }

  // The window's width in its own units and in pixels, which on dense displays are more.
  std::pair<int, int> widths() const {
    int units = 0;
    SDL_GetWindowSize(window_.get(), &units, nullptr);
    return {std::max(units, 1), std::max(pixel_size(renderer_.get()).width, 1)};
  }

  void present() {
    draw();
    SDL_RenderPresent(renderer_.get());
  }

  void draw() {
    const PixelSize size = pixel_size(renderer_.get());
    const double scale = density();
    const ImageSize room{
        std::max(1, size.width - static_cast<int>(std::lround(kPanelWidth * scale))),
        std::max(1, size.height)};
    desk_.set_room(room);
    desk_.refresh();
    SDL_SetRenderDrawColor(renderer_.get(), kSurround, kSurround, kSurround, 255);
    check(SDL_RenderClear(renderer_.get()) == 0, "cannot be drawn to");
    draw_picture(room);
    frames_due_ = std::max(0, frames_due_ - 1);
    hand_.set_density(scale);
    frame_->draw([&] {
      draw_over({static_cast<float>(room.width / scale), static_cast<float>(room.height / scale)});
      panel_.draw(desk_, hand_);
    });
    desk_.refresh();
  }

  // In the middle of its room; one of an earlier size is stretched until there is a new one.
  void draw_picture(ImageSize room) {
    const auto picture = desk_.picture();
    const bool is_new = std::exchange(drawn_, picture) != picture;
    const ImageSize size = desk_.picture_size();
    place_ = {(room.width - size.width) / 2, (room.height - size.height) / 2};
    if (!drawn_) return;
    if (is_new || !texture_) upload(drawn_->planes);
    const SDL_Rect to{place_.x, place_.y, size.width, size.height};
    check(SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &to) == 0, "cannot be drawn to");
  }

  void upload(const Planes& planes) {
    ImageSize now{0, 0};
    if (texture_) SDL_QueryTexture(texture_.get(), nullptr, nullptr, &now.width, &now.height);
    if (!(now == planes.size))
      texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888,
                                       SDL_TEXTUREACCESS_STREAMING, planes.size.width,
                                       planes.size.height));
    check(texture_ != nullptr, "cannot hold the picture");
    words_.resize(planes.size.pixels());
    for (std::size_t pixel = 0; pixel < words_.size(); ++pixel)
      words_[pixel] = argb(planes.at(pixel));
    check(SDL_UpdateTexture(texture_.get(), nullptr, words_.data(), 4 * planes.size.width) == 0,
          "cannot hold the picture");
  }

  // Handles, and what is under the mouse.
  void draw_over(const ImVec2& room) {
    const ModelOverlay over(glm::dvec2(place_.x, place_.y), density());
    if (desk_.interpreter().solids().empty())
      return over.invite("create a solid at the right, or open a scene: Ctrl+O", room);
    if (const auto handles = hand_.handles(desk_)) over.draw(*handles, hand_.axis(), hand_.holds());
    if (!hand_.told().empty()) return over.tell(hand_.told(), room);
    if (!mouse_ || button_ != 0) return;
    const glm::dvec2 at = in_picture(*mouse_);
    if (const auto probed =
            desk_.probe(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))))
      over.tell(text_of(*probed), room);
  }

  Video video_;
  Owned<SDL_Window> window_;
  Owned<SDL_Renderer> renderer_;
  Owned<SDL_Texture> texture_;
  ModelDesk desk_;  // its thread wakes the window: it goes first
  std::unique_ptr<PanelFrame> frame_;
  ModelPanel panel_;
  ModelHand hand_;
  std::shared_ptr<const modeler::PreviewPicture> drawn_;
  std::vector<std::uint32_t> words_;
  Spot place_, pressed_, last_;
  std::optional<Spot> mouse_;  // over the picture
  bool followed_ = true;       // where it is has been seen to
  std::uint8_t button_ = 0;    // that went down in the picture; 0: none
  bool moved_ = false, moved_over_ = false;
  std::atomic<bool> stopped_ = false;
  int frames_due_ = 2;
};

ModelWindow::ModelWindow(DeskOptions options, const std::function<void(ModelDesk&)>& prepare)
    : impl_(std::make_unique<Impl>(std::move(options), prepare)) {}

ModelWindow::~ModelWindow() = default;

void ModelWindow::run(std::stop_token stop) { impl_->run(std::move(stop)); }

void ModelWindow::settle() { impl_->settle(); }

ModelDesk& ModelWindow::desk() { return impl_->desk(); }

std::optional<ModelWindow::Spot> ModelWindow::find(const std::string& label) const {
  return impl_->find(label);
}

eltek::Screen ModelWindow::pixels() { return impl_->pixels(); }

}  // namespace sir::viewer
