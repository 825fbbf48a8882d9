// How the modeler's window looks: colours, letters, distances. The thesis's menus were of
// characters on a terminal (3.2). Only in builds with Dear ImGui.
#pragma once

#include <imgui.h>

namespace sir::viewer {

inline const ImVec4 kAlarm{1.00f, 0.48f, 0.40f, 1.00f};   ///< what is refused
inline const ImVec4 kAccent{0.45f, 0.71f, 0.98f, 1.00f};  ///< what is selected, or leads on
inline const ImVec4 kQuiet{0.60f, 0.62f, 0.66f, 1.00f};   ///< what is said besides

/// Around the picture; darker than the panel, lighter than the black of a background.
inline constexpr unsigned char kSurround = 26;

/// Sets colours and distances, and loads letters for pixels that are `density` to a unit of the
/// window: DejaVu Sans where the machine has it, which knows the accents of all names; else what
/// Dear ImGui brings. `smooth` edges cost SDL's software renderer half as much again. Before the
/// first drawing.
void set_model_style(float density, bool smooth);

/// Darkens what is around the dialog that is being drawn: Dear ImGui dims only its own, which the
/// picture is not.
void dim_around();

/// The button that does what the part it stands in is for.
void push_main_button();
void pop_main_button();

}  // namespace sir::viewer
