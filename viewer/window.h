// The MA120's screen in a window: the only user of SDL2 (thesis 3.5).
// Present only in builds with SIR_WITH_SDL.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "eltek/bus_listener.h"
#include "eltek/screen.h"
#include "viewer/screen_view.h"

namespace sir::viewer {

struct WindowOptions {
  bool image_area_only = false;             ///< see ScreenView
  std::filesystem::path screenshots = ".";  ///< folder of the screenshots
  /// Hears all that the session puts on the MA120's bus, from power-on until the window is
  /// destroyed, which it outlives; a TraceRecorder, for one. None: nobody does.
  eltek::BusListener* bus_listener = nullptr;
  /// Told where a screenshot went, or why it went nowhere.
  std::function<void(const std::string&)> report = [](const std::string&) {};
};

/// A resizable window with the screen at a whole multiple, nearest pixel,
/// centred. Keys:
///
///   arrows, Page Up and Down   previous and next image, each with its LUT
///   1 to 8                     a plane on and off;  0  all planes on
///   + and -                    multiple; the window follows where it can
///   F                          the largest multiple that fits (as at first)
///   S                          saves the indexed screen as a PNG
///   Esc, Q                     closes the window
///
/// It is drawn when something changes or the desktop asks for it, never by
/// the clock.
class Window {
 public:
  /// Opens the window. Throws FileError where there is no display (also where
  /// SDL would draw to none in silence) and for images that do not fit.
  Window(std::vector<ShownImage> images, WindowOptions options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Handles events until the window is closed, or `stop` is requested from
  /// wherever.
  void run(std::stop_token stop = {});

  const ScreenView& view() const;

  /// The multiple at which the screen is drawn now.
  int multiple() const;

  /// The title as it is set now.
  std::string title() const;

  /// The window's own pixels, drawn afresh and read back.
  eltek::Screen pixels();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sir::viewer
