// The modeler in a window: the picture at the left, trees, fields and commands at the right. The
// thesis's modeler is menus and a silhouette on demand (3.2). Only in builds with Dear ImGui.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "eltek/screen.h"
#include "viewer/model_desk.h"

namespace sir::viewer {

/// Left drag turns the camera around, right or middle drag moves it, the wheel zooms, a click
/// selects what is there. Ctrl+Z and Ctrl+Y undo and redo; F frames what is shown. It is drawn when
/// something changes or the desktop asks for it, never by the clock.
class ModelWindow {
 public:
  /// `prepare` puts on the desk what there is at first; what it throws comes out. The wake of the
  /// options is set here. Throws FileError where there is no display.
  ModelWindow(DeskOptions options, const std::function<void(ModelDesk&)>& prepare);
  ~ModelWindow();
  ModelWindow(const ModelWindow&) = delete;
  ModelWindow& operator=(const ModelWindow&) = delete;

  /// Handles events until the window is closed, or `stop` is requested from wherever.
  void run(std::stop_token stop = {});

  /// Handles the events that wait, and those to come until the picture is whole.
  void settle();

  ModelDesk& desk();

  /// The centre of a thing in the panel, by what is written on it, as it was last drawn; of the
  /// picture ("picture") its top left corner. In the window's units.
  struct Spot {
    int x = 0, y = 0;
  };
  std::optional<Spot> find(const std::string& label) const;

  /// The window's own pixels, drawn afresh and read back.
  eltek::Screen pixels();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sir::viewer
