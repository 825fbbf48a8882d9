// The viewer's panel: LUT, histogram, metrics, inspector, beside the picture. Made with Dear ImGui
// where that is there; the viewer does without. The thesis's monitor showed the picture alone.
#pragma once

#include <SDL.h>

#include <memory>

#include "viewer/viewer.h"

namespace sir::viewer {

/// A column of the window, right of the picture.
class Panel {
 public:
  virtual ~Panel() = default;

  /// In the window's units.
  virtual int width() const = 0;

  /// Hears of every event first. Returns whether it is for the panel alone.
  virtual bool takes(const SDL_Event& event) = 0;

  /// Draws it with SDL's renderer and does to the viewer what a person did in it.
  virtual void draw() = 0;
};

/// Null in builds without Dear ImGui.
std::unique_ptr<Panel> make_panel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer);

}  // namespace sir::viewer
