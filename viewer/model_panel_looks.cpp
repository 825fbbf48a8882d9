// The panel's parts that change how solids are looked at: view, camera, light
// (thesis 3.6.2, 3.6.3).
#include <imgui.h>

#include "viewer/model_panel.h"

namespace sir::viewer {
namespace {

// A field for numbers that are typed or dragged; true where they have changed.
bool field(const char* label, double* values, int count, double speed = 0.01) {
  ImGui::SetNextItemWidth(240);
  return ImGui::DragScalarN(label, ImGuiDataType_Double, values, count, static_cast<float>(speed),
                            nullptr, nullptr, "%.4g");
}

}  // namespace

void ModelPanel::draw_view(ModelDesk& desk) {
  ViewSettings view = desk.view();
  const auto box = [this](const char* label, bool& value) {
    ImGui::Checkbox(label, &value);
    note(label);
  };
  box("ghosts", view.ghosts);
  ImGui::SameLine();
  box("axes", view.axes);
  ImGui::SameLine();
  box("bounds", view.bounds);
  ImGui::SameLine();
  box("grid", view.grid);
  box("silhouette", view.silhouette);
  ImGui::SameLine();
  box("selected alone", view.alone);
  desk.set_view(view);
}

void ModelPanel::draw_camera(ModelDesk& desk) {
  CameraFile camera = desk.camera();
  bool changed = field("window", &camera.window.x, 2);
  changed |= field("target", &camera.target.x, 3);
  changed |= field("normal", &camera.normal.x, 3);
  changed |= field("distance", &camera.distance, 1);
  changed |= field("up", &camera.up.x, 3);
  if (!camera.parallel && field("focal", &camera.focal, 1)) changed = camera.focal_given = true;
  changed |= ImGui::Checkbox("parallel", &camera.parallel);
  note("parallel");
  if (changed) desk.set_camera(camera);
}

void ModelPanel::draw_light(ModelDesk& desk) {
  Lighting lighting = desk.lighting();
  bool changed = field("background", &lighting.background.x, 3);
  changed |= field("ambient", &lighting.ambient.x, 3);
  std::size_t taken = lighting.lights.size();
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    changed |= field("light at", &lighting.lights[i].position.x, 3, 0.1);
    changed |= field("r g b", &lighting.lights[i].intensity.x, 3);
    ImGui::SameLine();
    if (ImGui::SmallButton("x")) taken = i;
    ImGui::PopID();
  }
  if (taken < lighting.lights.size()) {
    lighting.lights.erase(lighting.lights.begin() + static_cast<std::ptrdiff_t>(taken));
    changed = true;
  }
  if (button("Add a light")) {
    lighting.lights.push_back({desk.camera().target + glm::dvec3(0, 10, 0), glm::dvec3(0.5)});
    changed = true;
  }
  if (changed) desk.set_lighting(lighting);
}

}  // namespace sir::viewer
