// SDL2 as the window uses it: its video part, what it lends out, its errors. Present only in
// builds with SIR_WITH_SDL. Stands for the laboratory's monitor being there at all (thesis 3.5).
#pragma once

#include <SDL.h>

#include <memory>
#include <string>

#include "eltek/screen.h"

namespace sir::viewer {

/// Throws a FileError of the window.
[[noreturn]] void fail(const std::string& reason);

/// Throws one, with SDL's reason, where something did not work.
void check(bool worked, const char* what);

/// SDL's video part for as long as this lives. Throws FileError where there is no display, also
/// where SDL would draw to none in silence, unless SDL_VIDEODRIVER asks for that by name. `way_out`
/// ends the message: what else a person can do.
class Video {
 public:
  static constexpr const char* kWayOut =
      "; run it on a desktop (DISPLAY or WAYLAND_DISPLAY set), or use --terminal or --png OUT.png";
  explicit Video(const std::string& way_out = kWayOut);
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

/// The size of what is drawn to, in pixels, which on dense displays are finer than the window's
/// units.
struct PixelSize {
  int width = 0, height = 0;
};
PixelSize pixel_size(SDL_Renderer* renderer);

/// What has been drawn, before it is presented, as colours.
eltek::Screen read_back(SDL_Renderer* renderer);

}  // namespace sir::viewer
