// From SDL's events to Dear ImGui's, for the panel (viewer/panel.h). Its own platform backend asks
// SDL where the mouse is, which events that were injected, as tests do, never moved.
#pragma once

#include <SDL.h>

#include <array>

namespace sir::viewer {

/// For one context of Dear ImGui, which must be the current one.
class PanelInput {
 public:
  PanelInput();

  /// Passes an event on; places of the mouse in the window's units.
  void pass(const SDL_Event& event);

  /// Before each drawing: the window's size, how dense its pixels are, and what the mouse's buttons
  /// do. A click that began and ended since the last drawing is down in this one.
  void begin_frame(SDL_Window* window, SDL_Renderer* renderer);

 private:
  std::array<bool, 3> held_{}, pressed_{};
};

}  // namespace sir::viewer
