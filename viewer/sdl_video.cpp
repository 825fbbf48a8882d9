#include "viewer/sdl_video.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "tracer/error.h"
#include "viewer/argb.h"

namespace sir::viewer {
void fail(const std::string& reason) { throw FileError("window", 0, reason); }

void check(bool worked, const char* what) {
  if (!worked) fail(std::string(what) + ": " + SDL_GetError());
}

Video::Video(const std::string& way_out) {
  // Ctrl+C stays with the program, the screen saver and compositor with the desktop.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetMainReady();
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
    fail(std::string("there is no display: ") + SDL_GetError() + way_out);
  // Without a display SDL takes a driver that shows nothing and reports success; that is right
  // only for one who asked for it by name.
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  const char* asked = SDL_GetHint(SDL_HINT_VIDEODRIVER);
  const bool by_name = asked != nullptr && driver == asked;
  if ((driver == "offscreen" || driver == "dummy") && !by_name) {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    fail("there is no display" + way_out);
  }
}

PixelSize pixel_size(SDL_Renderer* renderer) {
  PixelSize size;
  SDL_GetRendererOutputSize(renderer, &size.width, &size.height);
  return size;
}

eltek::Screen read_back(SDL_Renderer* renderer) {
  const PixelSize size = pixel_size(renderer);
  eltek::Screen screen{{size.width, size.height}, {}};
  std::vector<Argb> words(screen.size.pixels());
  check(SDL_RenderReadPixels(renderer, nullptr, SDL_PIXELFORMAT_ARGB8888, words.data(),
                             4 * size.width) == 0,
        "cannot be read back");
  screen.pixels.resize(words.size());
  std::transform(words.begin(), words.end(), screen.pixels.begin(), rgb);
  return screen;
}

}  // namespace sir::viewer
