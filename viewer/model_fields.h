// The fields of the modeler's panel: a label at the left, numbers or a colour behind it. Only in
// builds with Dear ImGui. The thesis's modeler asks for one number after the other (3.2.2.2).
#pragma once

#include <string>

#include <imgui.h>
#include <glm/vec3.hpp>

#include "modeler/node.h"

namespace sir::viewer {

/// Begins a line: the label, and the cursor where the fields begin.
void field_label(const char* label);

/// Numbers that are dragged, or typed into (Ctrl and a click); true where they have changed. Three
/// have the colours of the axes, where they are X, Y and Z.
struct NumberField {
  const char* label;
  double speed = 0.01;  ///< a pixel's worth
  const char* format = "%.4g";
  bool along_axes = false;
};
bool number_field(const NumberField& field, double* values, int count);

/// A colour as a swatch, which opens a chooser, and as numbers; 1 is full intensity.
bool colour_field(const char* label, glm::dvec3& colour);

/// A button with a name that a person gave, which may hold what Dear ImGui takes for a sign (`##`)
/// or be what is written on another button.
bool name_button(const std::string& name);

/// Writes such a name into the list (ImGui::BeginCombo) that has just been drawn without one.
void name_in_list(const std::string& name);

/// A button that is on or off.
bool chip(const char* label, bool on, const char* tip = nullptr);

/// A picture of a primitive or an operation, as high as a line, where the cursor is; it takes no
/// room and nothing can be done to it.
void draw_icon(const modeler::Node& node, const ImVec2& corner, ImU32 colour);

ImVec4 shown_colour(const glm::dvec3& colour);

/// The widest name that a row has room for, cut with dots where it is too long.
std::string fitting(const std::string& text, float width);

/// Red, green, blue for X, Y, Z, as the axes in the picture have them; for none, white.
ImU32 axis_colour(int axis, bool bright);

}  // namespace sir::viewer
