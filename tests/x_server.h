// A real X server that draws into memory (Xvfb), and what can be seen on its screen.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "eltek/screen.h"
#include "viewer/viewport.h"

namespace sir::test {

/// Stopped when this ends, or the test dies. Its members may be called by a thread that shares the
/// server with SDL's.
class XServer {
 public:
  /// On a display that is free; null where there is no Xvfb, or it does not start.
  static std::unique_ptr<XServer> start(ImageSize screen);
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// For DISPLAY.
  const std::string& display() const { return display_; }

  /// What the screen shows where its largest window is; of no size where there is none.
  eltek::Screen largest_window() const;

  /// Moves the mouse to a place of that window.
  void point(viewer::Place at) const;

 private:
  struct Connection;
  XServer(pid_t process, std::string display);
  eltek::Area largest_area() const;

  pid_t process_;
  std::string display_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace sir::test
