// What lies over the modeler's picture: handles, and a line about what is under the mouse. Only in
// builds with Dear ImGui. The thesis's silhouettes stand alone (3.2.2.9).
#pragma once

#include <optional>
#include <string>

#include <imgui.h>

#include "viewer/handles.h"

namespace sir::viewer {

/// Draws behind all windows of Dear ImGui, in the window's units.
class ModelOverlay {
 public:
  /// `corner` of the picture, in pixels, of which `density` are a unit.
  ModelOverlay(const glm::dvec2& corner, double density) : corner_(corner), density_(density) {}

  /// The handles, that of an axis bright; where one is held, no other.
  void draw(const Handles& handles, std::optional<int> axis, bool held) const;

  /// A line at the lower left corner of the room for the picture, cut to its width.
  void tell(const std::string& text, const ImVec2& room) const;

  /// A line in the middle of it.
  void invite(const std::string& text, const ImVec2& room) const;

 private:
  ImVec2 place(const glm::dvec2& at) const;
  void draw_line(const Handle& handle, HandleKind kind, bool bright) const;

  glm::dvec2 corner_;
  double density_;
};

}  // namespace sir::viewer
