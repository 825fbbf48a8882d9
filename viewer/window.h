// The viewer in a window (thesis 3.5), by SDL2, which glass, panel* and sdl_* use with it.
// Present only in builds with SIR_WITH_SDL.
#pragma once

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "eltek/screen.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// A resizable window with the screen at a whole multiple, nearest pixel, and what viewer/viewer.h
/// lets a person do to it; the keys are those of viewer/commands.h, and ? shows them.
///
/// It is drawn when something changes or the desktop asks for it, never by the clock.
class Window {
 public:
  /// Opens the window, and the inputs in the background. Throws FileError where there is no
  /// display (also where SDL would draw to none in silence).
  Window(const std::vector<std::filesystem::path>& inputs, ViewerOptions options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Handles events until the window is closed, or `stop` is requested from wherever. Throws
  /// FileError where none of the inputs can be shown at first: then there is nothing to look at.
  void run(std::stop_token stop = {});

  /// Handles events until all that was asked for is on the screen, or the window is closed.
  void settle();

  const Viewer& viewer() const;
  Viewer& viewer();

  /// The title as it is set now.
  std::string title() const;

  /// The window's own pixels, drawn afresh and read back.
  eltek::Screen pixels();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sir::viewer
