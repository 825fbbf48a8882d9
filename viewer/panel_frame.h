// A column of a window that Dear ImGui draws: its context between SDL's events and SDL's renderer.
// Only in builds with Dear ImGui. The thesis's menus are of characters (3.2).
#pragma once

#include <SDL.h>

#include <chrono>
#include <functional>
#include <optional>

#include "viewer/panel_input.h"

namespace sir::viewer {

/// `width`, and places of the mouse, in the window's units. The column is at the right. One at a
/// time: Dear ImGui has one context that is current.
class PanelFrame {
 public:
  PanelFrame(SDL_Window* window, SDL_Renderer* renderer, int width);
  ~PanelFrame();
  PanelFrame(const PanelFrame&) = delete;
  PanelFrame& operator=(const PanelFrame&) = delete;

  /// Hears of every event first. Returns whether it is for the panel alone: what happens over it,
  /// or while a list of it is open, and all that a hand does that took hold of something there
  /// until it lets go.
  bool takes(const SDL_Event& event);

  /// Whether a menu, a list or a dialog is open, which comes before all else.
  bool list_open() const;

  /// Keys and buttons that were held are nothing to it.
  void reset();

  /// Textures lost their content: they are made anew.
  void forget();

  /// Draws what `parts` makes. Esc closes the list that is open.
  void draw(const std::function<void()>& parts);

 private:
  enum class Owner { picture, panel };
  Owner owner_at(int x) const;
  void close_list();

  struct Context {
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  };

  Context context_;
  SDL_Window* window_;
  SDL_Renderer* renderer_;
  int width_;
  using Clock = std::chrono::steady_clock;
  PanelInput input_;
  Clock::time_point drawn_ = Clock::now();
  std::optional<Owner> holder_;  // of the mouse, while a button is down
};

}  // namespace sir::viewer
