// From SDL's events to Dear ImGui's, for the panel (viewer/panel.h). Its own platform backend asks
// SDL where the mouse is, which events that were injected, as tests do, never moved.
#pragma once

#include <SDL.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sir::viewer {

/// For one context of Dear ImGui, which must be the current one.
class PanelInput {
 public:
  PanelInput();
  PanelInput(const PanelInput&) = delete;  // Dear ImGui knows where it is
  PanelInput& operator=(const PanelInput&) = delete;

  /// Passes an event on; places of the mouse in the window's units.
  void pass(const SDL_Event& event);

  /// Nothing is held, and the mouse is nowhere.
  void reset();

  bool any_button_held() const { return held_[0] || held_[1] || held_[2]; }

  /// Before each drawing: the window's size, how dense its pixels are, and what the mouse's buttons
  /// do. What went down and up again since the last drawing, button or key, is down in this one.
  void begin_frame(SDL_Window* window, SDL_Renderer* renderer);

  /// After each drawing.
  void end_frame();

 private:
  void release_keys();

  std::array<bool, 3> held_{}, pressed_{};
  std::vector<std::size_t> rising_;  // keys that are down until the drawing is over
  std::string clipboard_;            // as it was last asked for
};

}  // namespace sir::viewer
