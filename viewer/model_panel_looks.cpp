// The panel's parts that change how solids are looked at: view, camera, light, surfaces
// (thesis 3.3, 3.6.2, 3.6.3). One drag of a field is one command.
#include <imgui.h>

#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "modeler/look_words.h"
#include "viewer/model_fields.h"
#include "viewer/model_panel.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

std::string three(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// To three digits behind the point, as the fields have them.
glm::dvec3 rounded(const glm::dvec3& v) { return glm::round(v * 1000.0) / 1000.0; }

void heading(const char* text) {
  ImGui::Spacing();
  ImGui::TextColored(kAccent, "%s", text);
}

}  // namespace

void ModelPanel::draw_view(const ModelDesk& desk) {
  const modeler::ViewSettings& view = desk.interpreter().view();
  for (const auto& word : modeler::view_words()) {
    const std::string label(word.english);
    const bool on = view.*word.value;
    if (chip(label.c_str(), on)) pending_.push_back("view " + label + (on ? " off" : " on"));
    note(label);
    ImGui::SameLine(0, 3);
  }
  ImGui::NewLine();
}

void ModelPanel::draw_camera(ModelDesk& desk) {
  CameraFile camera = desk.interpreter().camera();
  const double step = camera.window.y / 200;
  const auto three_of = [&](const char* word, glm::dvec3& v, double speed) {
    if (number_field({word, speed, "%.4g", true}, &v.x, 3))
      desk.drag(fmt::format("camera {} {}", word, three(v)));
    note(std::string("camera ") + word);
  };
  const auto one_of = [&](const char* word, double& value) {
    if (number_field({word, step}, &value, 1)) desk.drag(fmt::format("camera {} {}", word, value));
    note(std::string("camera ") + word);
  };
  three_of("target", camera.target, step);
  three_of("normal", camera.normal, 0.005);
  three_of("up", camera.up, 0.005);
  one_of("distance", camera.distance);
  if (number_field({"window", step}, &camera.window.x, 2))
    desk.drag(fmt::format("camera window {} {}", camera.window.x, camera.window.y));
  note("camera window");
  if (!camera.parallel) one_of("focal", camera.focal);
  field_label("");
  if (chip("perspective", !camera.parallel)) pending_.push_back("camera perspective");
  note("perspective");
  ImGui::SameLine(0, 2);
  if (chip("parallel", camera.parallel)) pending_.push_back("camera parallel");
  note("parallel");
  ImGui::SameLine(0, 14);
  if (button("Back")) pending_.push_back("undo camera");
  ImGui::SameLine();
  if (button("Forward")) pending_.push_back("redo camera");
}

void ModelPanel::draw_light(ModelDesk& desk) {
  Lighting lighting = desk.interpreter().lighting();
  const auto colour = [&](const char* label, glm::dvec3& value, const std::string& command) {
    if (colour_field(label, value)) desk.drag(fmt::format("light {} {}", command, three(value)));
    note(std::string("light ") + command);
  };
  colour("background", lighting.background, "background");
  colour("ambient", lighting.ambient, "ambient");
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    Light& light = lighting.lights[i];
    const std::size_t number = i + 1;
    ImGui::PushID(static_cast<int>(i));
    heading(fmt::format("light {}", number).c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize("delete").x -
                    2 * ImGui::GetStyle().FramePadding.x);
    if (ImGui::SmallButton("delete")) pending_.push_back(fmt::format("light delete {}", number));
    note(fmt::format("light delete {}", number));
    if (number_field({"at", desk.interpreter().camera().window.y / 200, "%.4g", true},
                     &light.position.x, 3))
      desk.drag(fmt::format("light move {} {}", number, three(light.position)));
    note(fmt::format("light move {}", number));
    colour("colour", light.intensity, fmt::format("colour {}", number));
    ImGui::PopID();
  }
  if (button("Add a light")) {
    // Over the observer's left shoulder there is one already; this one is over what is looked at.
    const CameraFile camera = desk.interpreter().camera();
    const glm::dvec3 above = camera.target + glm::dvec3(0, camera.window.y, 0);
    pending_.push_back(
        fmt::format("light add {:.4g} {:.4g} {:.4g} 0.5", above.x, above.y, above.z));
  }
}

void ModelPanel::draw_surfaces(ModelDesk& desk) {
  const auto surfaces = desk.interpreter().looks().surfaces;  // a drag changes those that are kept
  if (surfaces.empty()) ImGui::TextDisabled("none is described: each number has a hue of its own");
  for (const auto& [number, surface] : surfaces) {
    ImGui::PushID(std::to_string(number).c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    const bool open = ImGui::TreeNodeEx("##surface", ImGuiTreeNodeFlags_SpanAvailWidth, "       %s",
                                        fmt::format("{}  {}", number, surface.name).c_str());
    note(fmt::format("surface row {}", number));
    const float x = corner.x + ImGui::GetTreeNodeToLabelSpacing();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({x + 2, corner.y + 1}, {x + side, corner.y + side - 1},
                       ImGui::GetColorU32(shown_colour(colour_of(desk, number))), 2);
    if (surface.texture == TextureKind::chequer)
      list.AddRectFilled({x + side / 2 + 1, corner.y + 1}, {x + side, corner.y + side - 1},
                         ImGui::GetColorU32(shown_colour(surface.second.diffuse)), 2);
    if (open) {
      ImGui::Unindent();
      draw_coefficients(desk, surface, false);
      const bool chequer = surface.texture == TextureKind::chequer;
      field_label("texture");
      if (chip("plain", !chequer) && chequer)
        pending_.push_back(fmt::format("surface {} plain", number));
      ImGui::SameLine(0, 2);
      if (chip("chequer", chequer) && !chequer)
        pending_.push_back(fmt::format("surface {} chequer 8 8", number));
      if (chequer) {
        double cells[]{static_cast<double>(surface.cells_u), static_cast<double>(surface.cells_v)};
        if (number_field({"cells", 0.1, "%.0f"}, cells, 2))
          desk.drag(fmt::format("surface {} chequer {:.0f} {:.0f}", number, std::max(1.0, cells[0]),
                                std::max(1.0, cells[1])));
        heading("odd cells");
        draw_coefficients(desk, surface, true);
      }
      field_label("");
      if (ImGui::SmallButton("delete"))
        pending_.push_back(fmt::format("surfaces delete {}", number));
      ImGui::Indent();
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
  ImGui::SetNextItemWidth(180);
  choose_surface(desk, "describe", described_);
  ImGui::SameLine();
  if (button("Describe"))
    pending_.push_back(fmt::format("surface {} colour {}", described_,
                                   three(rounded(colour_of(desk, described_)))));
}

void ModelPanel::draw_coefficients(ModelDesk& desk, const Surface& surface, bool odd) {
  Coefficients cells = odd ? surface.second : surface.first;
  const std::string command = fmt::format("surface {}{} ", surface.number, odd ? " odd" : "");
  const auto colour = [&](const char* label, glm::dvec3& value) {
    if (colour_field(label, value)) desk.drag(command + label + " " + three(value));
    note(command + label);
  };
  const auto number = [&](const char* label, double& value, double speed) {
    if (number_field({label, speed, "%.3f"}, &value, 1))
      desk.drag(fmt::format("{}{} {}", command, label, std::max(0.0, value)));
    note(command + label);
  };
  ImGui::PushID(odd);
  colour("ambient", cells.ambient);
  colour("diffuse", cells.diffuse);
  number("specular", cells.specular, 0.005);
  number("exponent", cells.exponent, 0.5);
  number("transmission", cells.transmission, 0.005);
  number("index", cells.index, 0.005);
  ImGui::PopID();
}

}  // namespace sir::viewer
