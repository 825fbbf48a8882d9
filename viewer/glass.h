// The monitor's glass: a picture in whole multiples and what is written over it, by SDL's renderer.
// Present only in builds with SIR_WITH_SDL.
#pragma once

#include <cstdint>
#include <vector>

#include "viewer/canvas.h"
#include "viewer/sdl_video.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// Draws what a viewer shows into the left part of a renderer, as large as the viewer's window.
/// Scaling is by nearest pixel whatever the environment wants of SDL.
class Glass {
 public:
  explicit Glass(SDL_Renderer* renderer) : renderer_(renderer) {}

  /// Letters over the picture are `scale` times as large. Throws FileError.
  void draw(Viewer& viewer, int scale);

  /// Textures lost their content: they are made anew.
  void forget();

 private:
  void draw_picture(Viewer& viewer);
  void draw_text(Viewer& viewer, int scale);
  bool fit(Owned<SDL_Texture>& texture, ImageSize size, SDL_BlendMode blend);

  SDL_Renderer* renderer_;
  Owned<SDL_Texture> picture_, text_;
  std::uint64_t picture_version_ = 0;  // that picture_ holds; 0: none
  std::vector<Argb> words_;            // of text_; all 0 but for painted_
  Rectangle painted_;
};

}  // namespace sir::viewer
