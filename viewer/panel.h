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

  /// Hears of every event first, while it is open. Returns whether it is for the panel alone: what
  /// happens over it, and all that a hand does that took hold of something there until it lets go.
  virtual bool takes(const SDL_Event& event) = 0;

  /// It has been opened or closed: keys and buttons that were held then are nothing to it.
  virtual void reset() = 0;

  /// Textures lost their content: they are made anew.
  virtual void forget() = 0;

  /// Draws it with SDL's renderer and does to the viewer what a person did in it.
  virtual void draw() = 0;
};

/// Null in builds without Dear ImGui.
std::unique_ptr<Panel> make_panel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer);

}  // namespace sir::viewer
