// The panel's parts that make solids (cria and combina sólido, thesis 3.2.2.1, 3.2.2.3).
#include <imgui.h>

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/operations.h"
#include "viewer/model_panel.h"

namespace sir::viewer {

using modeler::as_word;

void ModelPanel::draw_create(ModelDesk& desk) {
  const auto kinds = modeler::kinds();
  const auto kind = static_cast<std::size_t>(kind_);
  const std::string proposed =
      modeler::free_name(desk.interpreter().solids(), std::string(kinds[kind].english));
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float make = ImGui::CalcTextSize("Create").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float room = ImGui::GetContentRegionAvail().x - make - 3 * spacing;
  ImGui::SetNextItemWidth(room * 0.36f);
  const bool entered =
      ImGui::InputTextWithHint("##new name", proposed.c_str(), new_name_.data(), new_name_.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue);
  note("new name");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(room * 0.30f);
  if (ImGui::BeginCombo("##kind", kinds[kind].english.data())) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (ImGui::Selectable(kinds[i].english.data(), i == kind)) kind_ = static_cast<int>(i);
      note(kinds[i].english.data());
    }
    ImGui::EndCombo();
  }
  note("kind");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(room * 0.34f);
  choose_surface(desk, "surface", surface_);
  ImGui::SameLine();
  if (!button("Create##do") && !entered) return;
  const std::string name = as_word(new_name_[0] != 0 ? new_name_.data() : proposed);
  pending_ = {fmt::format("create {} {} {}", name, kinds[kind].english, surface_),
              "select " + name};
  new_name_[0] = 0;
}

void ModelPanel::draw_combine(ModelDesk& desk) {
  const auto operations = modeler::operations();
  const auto operation = static_cast<std::size_t>(operation_);
  const std::string proposed = modeler::free_name(desk.interpreter().solids(), "solid");
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - 2 * spacing;
  ImGui::SetNextItemWidth(room * 0.35f);
  choose_solid(desk, "left", left_);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(room * 0.30f);
  if (ImGui::BeginCombo("##operation", operations[operation].english.data())) {
    for (std::size_t i = 0; i < operations.size(); ++i) {
      if (ImGui::Selectable(operations[i].english.data(), i == operation))
        operation_ = static_cast<int>(i);
      note(operations[i].english.data());
    }
    ImGui::EndCombo();
  } else {
    note("operation");
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(room * 0.35f);
  choose_solid(desk, "right", right_);
  ImGui::SetNextItemWidth(room * 0.35f);
  const bool entered =
      ImGui::InputTextWithHint("##combined", proposed.c_str(), combined_name_.data(),
                               combined_name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  note("combined name");
  ImGui::SameLine();
  if ((!button("Combine##do") && !entered) || left_.empty() || right_.empty()) return;
  const std::string name = as_word(combined_name_[0] != 0 ? combined_name_.data() : proposed);
  pending_ = {fmt::format("combine {} {} {} {}", name, as_word(left_),
                          operations[operation].english, as_word(right_)),
              "select " + name};
  combined_name_[0] = 0;
}

}  // namespace sir::viewer
