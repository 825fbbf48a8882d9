#include "viewer/model_panel.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "modeler/command_line.h"
#include "viewer/model_fields.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

constexpr float kScript = 84, kMessage = 58;  // heights

}  // namespace

void ModelPanel::draw(ModelDesk& desk, ModelHand& hand) {
  spots_.clear();
  const auto& selection = desk.interpreter().selection();
  reveal_ = selection != revealed_;
  revealed_ = selection;
  draw_tools(desk, hand);
  draw_view(desk);
  const float below = kScript + kMessage + ImGui::GetFrameHeight() + 22;
  ImGui::BeginChild("parts", {0, -below});
  if (part("Solids", true)) draw_solids(desk);
  if (part("Selected", true)) draw_selected(desk);
  if (part("Create", true)) draw_create(desk);
  if (std::exchange(open_combine_, false)) ImGui::SetNextItemOpen(true);
  if (part("Combine", false)) draw_combine(desk);
  if (part("Camera", false)) draw_camera(desk);
  if (part("Light", false)) draw_light(desk);
  if (part("Surfaces", false)) draw_surfaces(desk);
  ImGui::EndChild();
  draw_commands(desk);
  files_.draw(desk, [this](const std::string& label) { note(label); });
  if (auto line = offer_.draw([this](const std::string& label) { note(label); }))
    pending_.push_back(std::move(*line));
  for (const std::string& line : std::exchange(pending_, {}))
    if (!desk.execute(line)) break;
  // A drag ends where the hand lets go of the field, or Tab leads on to the next.
  const ImGuiID active = ImGui::GetActiveID();
  const ImGuiID before = std::exchange(active_, active);
  if (before != 0 && before != active) desk.end_drag();
}

void ModelPanel::draw_tools(ModelDesk& desk, ModelHand& hand) {
  if (button("File")) ImGui::OpenPopup("file menu");
  ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 2});
  if (ImGui::BeginPopup("file menu")) {
    files_.draw_menu(desk, [this](const std::string& label) { note(label); });
    ImGui::EndPopup();
  }
  ImGui::SameLine();
  if (button("Undo")) pending_.push_back("undo");
  ImGui::SameLine();
  if (button("Redo")) pending_.push_back("redo");
  ImGui::SameLine();
  if (button("Frame")) desk.frame();
  struct Tool {
    const char* label;
    HandleKind kind;
    const char* tip;
  };
  constexpr std::array kTools{
      Tool{"Move", HandleKind::move, "handles that move (G)"},
      Tool{"Turn", HandleKind::turn, "handles that turn (R)"},
      Tool{"Scale", HandleKind::scale, "handles that scale (S)"},
  };
  float width = 0;
  for (const Tool& tool : kTools)
    width += ImGui::CalcTextSize(tool.label).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width - 4);
  for (const Tool& tool : kTools) {
    if (chip(tool.label, hand.kind == tool.kind, tool.tip))
      hand.kind = hand.kind == tool.kind ? std::nullopt : std::optional(tool.kind);
    note(tool.label);
    ImGui::SameLine(0, 2);
  }
  ImGui::NewLine();
}

void ModelPanel::draw_commands(ModelDesk& desk) {
  const std::vector<std::string>& script = desk.script();
  ImGui::BeginChild("script", {0, kScript}, true);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(script.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const std::string& line = script[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      if (ImGui::Selectable("##line")) line_.propose(line);
      ImGui::PopID();
      note("line " + std::to_string(i + 1));
      ImGui::SameLine(0, 0);
      ImGui::TextUnformatted(line.c_str());
    }
  if (std::exchange(commands_, script.size()) != script.size()) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
  ImGui::BeginChild("message", {0, kMessage}, true);
  ImGui::PushTextWrapPos(0);
  const std::string trouble = desk.trouble();
  if (!line_.offered().empty()) {
    ImGui::TextColored(kQuiet, "%s", line_.offered().c_str());
  } else if (desk.refused() || !trouble.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kAlarm);
    ImGui::TextUnformatted((desk.refused() ? desk.message() : trouble).c_str());
    ImGui::PopStyleColor();
  } else {
    ImGui::TextUnformatted(desk.message().c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  ImGui::SetNextItemWidth(-1);
  if (auto line = line_.draw(desk.interpreter())) pending_.push_back(std::move(*line));
  note("command");
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
  const std::string id = std::string("##") + label;
  const std::string shown = name.empty() ? label : name;
  if (ImGui::BeginCombo(id.c_str(), "")) {
    for (const auto& [place, entry] : desk.interpreter().solids().entries()) {
      ImGui::PushID(static_cast<int>(place));
      if (ImGui::Selectable("##solid", entry->name == name)) name = entry->name;
      ImGui::SameLine(0, 0);
      ImGui::TextUnformatted(entry->name.c_str());
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  name_in_list(shown);
  note(label);
}

void ModelPanel::note(const std::string& label) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  spots_[label] = {static_cast<int>((low.x + high.x) / 2), static_cast<int>((low.y + high.y) / 2)};
}

}  // namespace sir::viewer
