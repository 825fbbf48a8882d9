// What stands in the panel, from top to bottom. Only in builds with Dear ImGui. The thesis has no
// such thing; what is shown is of its sections 3.4 and 3.5.
#pragma once

#include "viewer/panel_lut.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// Draws into the window that Dear ImGui has open.
class PanelParts {
 public:
  void draw(Viewer& viewer);

 private:
  void draw_colours(Viewer& viewer);
  void draw_machine(Viewer& viewer);
  void draw_histogram(Viewer& viewer);
  void draw_judgement(Viewer& viewer);
  void draw_inspector(Viewer& viewer);
  void draw_trace(Viewer& viewer);

  LutPart lut_;
  int primary_ = 1;
};

}  // namespace sir::viewer
