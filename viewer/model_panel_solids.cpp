// The panel's parts that change solids (thesis 3.2.2.1 to 3.2.2.6).
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/inspect.h"
#include "modeler/operations.h"
#include "viewer/model_panel.h"

namespace sir::viewer {
namespace {

using modeler::as_word;
using modeler::Node;

constexpr int kDeepest = 200;  // of the tree's levels that are shown
constexpr const char* kSolid = "solid";
constexpr const char* kAxes[]{"x", "y", "z"};

std::string row(const Node& node) {
  if (const auto* composite = node.composite())
    return fmt::format("{}: {}", node.name, modeler::name_of(composite->operation));
  const modeler::Primitive& primitive = *node.primitive();
  return fmt::format("{}: {}, surface {}{}", node.name, modeler::name_of(primitive.kind),
                     primitive.surfaces[0], primitive.surface_per_face ? " ..." : "");
}

double size_of(const Node& node) {
  const glm::dvec3 extent = node.bounds.high - node.bounds.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  return size > 0 && std::isfinite(size) ? size : 1;
}

bool drag(const char* label, double* values, int count, double speed) {
  return ImGui::DragScalarN(label, ImGuiDataType_Double, values, count, static_cast<float>(speed),
                            nullptr, nullptr, "%.3f");
}

}  // namespace

void ModelPanel::draw_solids(ModelDesk& desk) {
  if (desk.interpreter().solids().empty()) return ImGui::TextDisabled("none yet");
  for (const auto& [place, entry] : desk.interpreter().solids().entries()) {
    ImGui::PushID(entry->name.c_str());
    draw_node(desk, entry->name, *entry->solid.tree(), 0, 0);
    ImGui::PopID();
  }
}

void ModelPanel::draw_node(ModelDesk& desk, const std::string& solid, const Node& node,
                           std::size_t place, int depth) {
  const auto* composite = node.composite();
  const auto& chosen = desk.selection();
  const bool here = chosen && chosen->solid == solid;
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
  if (here && chosen->place == place) flags |= ImGuiTreeNodeFlags_Selected;
  if (composite == nullptr || depth == kDeepest) flags |= ImGuiTreeNodeFlags_Leaf;
  if (reveal_ && here && chosen->place > place && chosen->place < place + node.count)
    ImGui::SetNextItemOpen(true);
  const std::string id = std::to_string(place);
  const bool open = ImGui::TreeNodeEx(id.c_str(), flags, "%s", row(node).c_str());
  if (place == 0) note("\"" + solid + "\"");
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) desk.select(Selection{solid, place});
  if (place == 0) draw_drop(solid);
  if (!open) return;
  if (composite != nullptr && depth < kDeepest) {
    draw_node(desk, solid, *composite->left, place + 1, depth + 1);
    draw_node(desk, solid, *composite->right, place + 1 + composite->left->count, depth + 1);
  }
  ImGui::TreePop();
}

// One solid let go over another: they are to be combined.
void ModelPanel::draw_drop(const std::string& solid) {
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kSolid, solid.data(), solid.size());
    ImGui::TextUnformatted(solid.c_str());
    ImGui::EndDragDropSource();
  }
  if (!ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kSolid)) {
    left_ = solid;
    right_.assign(static_cast<const char*>(payload->Data),
                  static_cast<std::size_t>(payload->DataSize));
    open_combine_ = true;
  }
  ImGui::EndDragDropTarget();
}

void ModelPanel::draw_selected(ModelDesk& desk) {
  const Node* node = desk.selected_node();
  if (node == nullptr) return ImGui::TextDisabled("nothing: click a solid, or its row");
  const std::string solid = desk.selection()->solid;
  const std::string word = as_word(solid);
  ImGui::PushTextWrapPos(0);
  if (desk.selection()->place != 0)
    ImGui::TextUnformatted(
        fmt::format("{}, part of \"{}\"; changes are the whole solid's", row(*node), solid)
            .c_str());
  else ImGui::TextUnformatted(fmt::format("\"{}\": {}", solid, modeler::type_text(*node)).c_str());
  const auto& box = node->bounds;
  ImGui::TextUnformatted(fmt::format("{:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g}", box.low.x,
                                     box.low.y, box.low.z, box.high.x, box.high.y, box.high.z)
                             .c_str());
  ImGui::PopTextWrapPos();
  draw_moves(desk, word, size_of(*node));
  const auto& solids = desk.interpreter().solids();
  if (button("Copy")) pending_ = "copy " + word + " " + as_word(modeler::free_name(solids, solid));
  ImGui::SameLine();
  if (button("Split")) pending_ = "split " + word;
  ImGui::SameLine();
  if (button("Delete")) pending_ = "delete " + word;
}

// Fields that a hand drags, or types into. What one drag does is one command, however long it was.
void ModelPanel::draw_moves(ModelDesk& desk, const std::string& word, double size) {
  const auto released = [&] {
    const bool is = ImGui::IsItemDeactivated();
    if (is) desk.end_drag();
    return is;
  };
  ImGui::SetNextItemWidth(240);
  if (drag("move", &moved_.x, 3, size / 200))
    desk.drag(moved_ == glm::dvec3(0)
                  ? ""
                  : fmt::format("translate {} {} {} {}", word, moved_.x, moved_.y, moved_.z));
  note("move");
  if (released()) moved_ = glm::dvec3(0);
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SetNextItemWidth(80);
    ImGui::PushID(axis);
    double& degrees = turned_[axis];
    if (drag("##turn", &degrees, 1, 1))
      desk.drag(degrees == 0 ? "" : fmt::format("rotate {} {} {}", word, kAxes[axis], degrees));
    note(std::string("turn ") + kAxes[axis]);
    if (released()) degrees = 0;
    ImGui::PopID();
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  }
  ImGui::TextUnformatted("turn about x y z");
  ImGui::SetNextItemWidth(240);
  if (drag("scale", &scaled_.x, 3, 0.01))
    desk.drag(scaled_ == glm::dvec3(1)
                  ? ""
                  : fmt::format("scale {} {} {} {}", word, scaled_.x, scaled_.y, scaled_.z));
  note("scale");
  if (released()) scaled_ = glm::dvec3(1);
  ImGui::SetNextItemWidth(80);
  if (drag("scale all", &factor_, 1, 0.01))
    desk.drag(factor_ == 1 ? "" : fmt::format("scale {} {}", word, factor_));
  note("scale all");
  if (released()) factor_ = 1;
}

void ModelPanel::draw_create(ModelDesk& desk) {
  const auto kinds = modeler::kinds();
  const auto kind = static_cast<std::size_t>(kind_);
  const std::string proposed =
      modeler::free_name(desk.interpreter().solids(), std::string(kinds[kind].english));
  ImGui::SetNextItemWidth(110);
  ImGui::InputTextWithHint("##new name", proposed.c_str(), new_name_.data(), new_name_.size());
  note("new name");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(90);
  if (ImGui::BeginCombo("##kind", kinds[kind].english.data())) {
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (ImGui::Selectable(kinds[i].english.data(), i == kind)) kind_ = static_cast<int>(i);
    ImGui::EndCombo();
  }
  note("kind");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(80);
  ImGui::InputInt("##surface", &surface_);
  note("surface");
  ImGui::SameLine();
  if (!button("Create##do")) return;
  const std::string name = new_name_[0] != 0 ? new_name_.data() : proposed;
  if (desk.execute(fmt::format("create {} {} {}", as_word(name), kinds[kind].english, surface_)))
    desk.select(Selection{name, 0});
  new_name_[0] = 0;
}

void ModelPanel::draw_combine(ModelDesk& desk) {
  const auto operations = modeler::operations();
  const auto operation = static_cast<std::size_t>(operation_);
  const std::string proposed = modeler::free_name(desk.interpreter().solids(), "solid");
  ImGui::SetNextItemWidth(130);
  choose_solid(desk, "left", left_);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(110);
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
  ImGui::SetNextItemWidth(130);
  choose_solid(desk, "right", right_);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(110);
  ImGui::InputTextWithHint("##combined", proposed.c_str(), combined_name_.data(),
                           combined_name_.size());
  note("combined name");
  ImGui::SameLine();
  if (!button("Combine##do") || left_.empty() || right_.empty()) return;
  const std::string name = combined_name_[0] != 0 ? combined_name_.data() : proposed;
  if (desk.execute(fmt::format("combine {} {} {} {}", as_word(name), as_word(left_),
                               operations[operation].english, as_word(right_))))
    desk.select(Selection{name, 0});
  combined_name_[0] = 0;
}

}  // namespace sir::viewer
