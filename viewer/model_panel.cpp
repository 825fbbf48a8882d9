#include "viewer/model_panel.h"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "modeler/command_line.h"

namespace sir::viewer {
namespace {

constexpr float kBelow = 195;  // of the commands' part
const ImVec4 kAlarm{1.0f, 0.45f, 0.35f, 1.0f};

}  // namespace

void ModelPanel::draw(ModelDesk& desk) {
  spots_.clear();
  reveal_ = desk.selection() != revealed_;
  revealed_ = desk.selection();
  ImGui::BeginChild("parts", {0, -kBelow});
  if (button("Undo")) pending_ = "undo";
  ImGui::SameLine();
  if (button("Redo")) pending_ = "redo";
  ImGui::SameLine();
  if (button("Frame")) desk.frame();
  ImGui::SameLine();
  ImGui::TextDisabled("left, right drag, wheel: camera");
  draw_view(desk);
  if (part("Solids", true)) draw_solids(desk);
  if (part("Selected", true)) draw_selected(desk);
  if (part("Create", true)) draw_create(desk);
  if (std::exchange(open_combine_, false)) ImGui::SetNextItemOpen(true);
  if (part("Combine", false)) draw_combine(desk);
  if (part("Camera", false)) draw_camera(desk);
  if (part("Light", false)) draw_light(desk);
  if (part("File", false)) draw_file(desk);
  ImGui::EndChild();
  ImGui::Separator();
  draw_commands(desk);
  if (pending_.empty()) return;
  desk.execute(pending_);
  pending_.clear();
}

void ModelPanel::draw_commands(ModelDesk& desk) {
  const std::vector<std::string> script = desk.script();
  ImGui::BeginChild("script", {0, 90}, true);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(script.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      ImGui::TextUnformatted(script[static_cast<std::size_t>(i)].c_str());
  if (std::exchange(commands_, script.size()) != script.size()) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
  ImGui::BeginChild("message", {0, 62}, true);
  ImGui::PushTextWrapPos(0);
  if (desk.refused()) ImGui::PushStyleColor(ImGuiCol_Text, kAlarm);
  ImGui::TextUnformatted(desk.message().c_str());
  if (desk.refused()) ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(to_line_, false)) ImGui::SetKeyboardFocusHere();
  if (input("##command", line_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    pending_ = line_.data();
    line_[0] = 0;
    to_line_ = true;
  }
  note("command");
}

void ModelPanel::draw_file(ModelDesk& desk) {
  ImGui::SetNextItemWidth(200);
  input("file", file_name_);
  const std::string file = file_name_.data();
  const auto save = [&](const char* label) { return button(label) && !file.empty(); };
  if (save("Save .CSG") && desk.selection())
    pending_ = "save " + modeler::as_word(desk.selection()->solid) + " " + modeler::as_word(file);
  ImGui::SameLine();
  if (save("Save .CAM")) desk.save_camera(file);
  ImGui::SameLine();
  if (save("Save .LUZ")) desk.save_lighting(file);
  ImGui::SameLine();
  if (save("Save script")) desk.save_script(file);
}

bool ModelPanel::button(const char* label) {
  const bool pressed = ImGui::Button(label);
  note(label);
  return pressed;
}

bool ModelPanel::part(const char* label, bool open) {
  const bool is_open = ImGui::CollapsingHeader(label, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  note(label);
  return is_open;
}

bool ModelPanel::input(const char* label, Text& text, int flags) {
  const bool entered = ImGui::InputText(label, text.data(), text.size(), flags);
  note(label);
  return entered;
}

void ModelPanel::choose_solid(const ModelDesk& desk, const char* label, std::string& name) {
  if (desk.interpreter().solids().find(name) == nullptr) name.clear();
  if (ImGui::BeginCombo(label, name.c_str())) {
    for (const auto& [place, entry] : desk.interpreter().solids().entries()) {
      ImGui::PushID(static_cast<int>(place));
      if (ImGui::Selectable("##solid", entry->name == name)) name = entry->name;
      ImGui::SameLine(0, 0);
      ImGui::TextUnformatted(entry->name.c_str());
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  note(label);
}

void ModelPanel::note(const std::string& label) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  spots_[label] = {static_cast<int>((low.x + high.x) / 2), static_cast<int>((low.y + high.y) / 2)};
}

}  // namespace sir::viewer
