// The panel's part that changes what is selected, a solid or a part of it in place (thesis 3.2.2.2
// to 3.2.2.6).
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/inspect.h"
#include "modeler/operations.h"
#include "modeler/view.h"
#include "tracer/intersect.h"
#include "tracer/names.h"
#include "viewer/model_fields.h"
#include "viewer/model_panel.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

using modeler::as_word;
using modeler::Node;
using modeler::Selection;

constexpr const char* kAxes[]{"x", "y", "z"};

double size_of(const Node& node) {
  const glm::dvec3 extent = node.bounds.high - node.bounds.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  return size > 0 && std::isfinite(size) ? size : 1;
}

std::string three(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// The surface number that all primitives of a solid have on all faces; none where they differ.
std::optional<std::int64_t> surface_of(const Node& tree) {
  std::optional<std::int64_t> common;
  for (const Node* node : modeler::preorder(tree)) {
    const modeler::Primitive* primitive = node->primitive();
    if (primitive == nullptr) continue;
    for (int face = 0; face < face_count(primitive->kind); ++face) {
      const std::int64_t surface = primitive->surfaces[static_cast<std::size_t>(face)];
      if (common.value_or(surface) != surface) return std::nullopt;
      common = surface;
    }
  }
  return common;
}

}  // namespace

void ModelPanel::draw_selected(ModelDesk& desk) {
  const Node* found = desk.selected_node();
  if (found == nullptr) return ImGui::TextDisabled("nothing: click a solid, or its row");
  const Selection what = *desk.interpreter().selection();
  // A command may do away with the node while the rest is drawn.
  const modeler::NodePtr tree = desk.interpreter().solids().find(what.solid)->solid.tree();
  const Node& node = *found;
  const bool whole = what.place == 0;
  std::string text = modeler::type_text(node);
  if (!whole) text += fmt::format(", place {} of", what.place);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      fitting(text, ImGui::GetContentRegionAvail().x - (whole ? 0 : 90)).c_str());
  if (!whole) {
    ImGui::SameLine();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    if (name_button(fitting(what.solid, 84))) pending_.push_back("select " + as_word(what.solid));
    ImGui::PopStyleVar();
    note("whole");
  }
  const auto& box = node.bounds;
  ImGui::TextDisabled("%s", fmt::format("{:.4g} {:.4g} {:.4g}  to  {:.4g} {:.4g} {:.4g}", box.low.x,
                                        box.low.y, box.low.z, box.high.x, box.high.y, box.high.z)
                                .c_str());
  draw_name(what, node);
  draw_moves(desk, what, node);
  if (const auto* composite = node.composite()) draw_operation_of(what, *composite);
  draw_surfaces_of(desk, what, node);
  if (!whole) return;
  const auto& solids = desk.interpreter().solids();
  const std::string word = as_word(what.solid);
  if (button("Copy")) {
    const std::string copy = as_word(modeler::free_name(solids, what.solid));
    pending_ = {"copy " + word + " " + copy, "select " + copy};
  }
  ImGui::SameLine();
  if (node.composite() != nullptr && button("Split")) pending_.push_back("split " + word);
  if (node.composite() != nullptr) ImGui::SameLine();
  if (button("Delete")) pending_.push_back("delete " + word);
}

// A whole solid's name is that of the list; a part's is the one that the .CSG has.
void ModelPanel::draw_name(const Selection& what, const Node& node) {
  const std::string& name = what.place == 0 ? what.solid : node.name;
  const Selection who{what.solid, what.place, {}};
  if (named_ != who || written_ != name) {
    named_ = who;
    written_ = name;
    const std::size_t size = std::min(name.size(), name_.size() - 1);
    std::memcpy(name_.data(), name.data(), size);
    name_[size] = 0;
  }
  field_label("name");
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputText("##name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  note("name");
  // Of a name that is longer than the field, what stands there is no other name.
  if (!entered || written_.substr(0, name_.size() - 1) == name_.data()) return;
  const std::string word = as_word(name_.data());
  pending_.push_back(what.place == 0 ? "rename " + as_word(what.solid) + " " + word
                                     : change_of(what, "label", word));
  written_.clear();  // what stands there next is what came of it
}

// Fields that a hand drags, or types into. What one drag does is one command, however long it was.
void ModelPanel::draw_moves(ModelDesk& desk, const Selection& what, const Node& node) {
  // What was held may have gone while it was, with the selection.
  if (active_ == 0) {
    moved_ = turned_ = glm::dvec3(0);
    scaled_ = glm::dvec3(1);
    factor_ = 1;
  }
  const auto released = [] { return ImGui::IsItemDeactivated(); };
  const auto give = [&](bool changed, bool nothing, const char* verb,
                        const std::string& arguments) {
    if (changed) desk.drag(nothing ? "" : change_of(what, verb, arguments));
  };
  const bool moved = number_field({"move", size_of(node) / 200, "%.3f", true}, &moved_.x, 3);
  note("move");
  give(moved, moved_ == glm::dvec3(0), "translate", three(moved_));
  if (released()) moved_ = glm::dvec3(0);
  field_label("turn");
  const float width =
      (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemInnerSpacing.x) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::PushID(axis);
    ImGui::SetNextItemWidth(width);
    double& degrees = turned_[axis];
    const bool turned =
        ImGui::DragScalar("##turn", ImGuiDataType_Double, &degrees, 1, nullptr, nullptr, "%.1f°");
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    note(std::string("turn ") + kAxes[axis]);
    give(turned, degrees == 0, "rotate", fmt::format("{} {}", kAxes[axis], degrees));
    if (released()) degrees = 0;
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + 2}, {low.x + 2, high.y - 2},
                                              axis_colour(axis, false));
    ImGui::PopID();
    if (axis < 2) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  }
  const bool scaled = number_field({"scale", 0.01, "%.3f", true}, &scaled_.x, 3);
  note("scale");
  give(scaled, scaled_ == glm::dvec3(1), "scale", three(scaled_));
  if (released()) scaled_ = glm::dvec3(1);
  const bool grown = number_field({"scale all", 0.01, "%.3f"}, &factor_, 1);
  note("scale all");
  give(grown, factor_ == 1, "scale", fmt::format("{}", factor_));
  if (released()) factor_ = 1;
}

void ModelPanel::draw_operation_of(const Selection& what, const modeler::Composite& composite) {
  field_label("operation");
  for (const auto& word : modeler::operations()) {
    const std::string label(word.english);
    if (chip(label.c_str(), word.value == composite.operation) && word.value != composite.operation)
      pending_.push_back(change_of(what, "operation", label));
    note("be " + label);
    ImGui::SameLine(0, 2);
  }
  ImGui::NewLine();
}

void ModelPanel::draw_surfaces_of(ModelDesk& desk, const Selection& what, const Node& node) {
  const std::optional<std::int64_t> common = surface_of(node);
  field_label("surface");
  std::int64_t number = common.value_or(-1);
  ImGui::SetNextItemWidth(-1);
  if (choose_surface(desk, "all faces", number))
    pending_.push_back(change_of(what, "paint", std::to_string(number)));
  const modeler::Primitive* primitive = node.primitive();
  if (primitive == nullptr || !what.face || face_count(primitive->kind) == 1) return;
  const auto face = static_cast<std::size_t>(*what.face);
  field_label("face");
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(kAccent, "%s", std::string(face_name(primitive->kind, *what.face)).c_str());
  ImGui::SameLine(0, 10);
  std::int64_t of_face = primitive->surfaces[face];
  ImGui::SetNextItemWidth(-1);
  if (!choose_surface(desk, "face", of_face)) return;
  std::string numbers;
  const auto faces = static_cast<std::size_t>(face_count(primitive->kind));
  for (std::size_t i = 0; i < faces; ++i)
    numbers += (i == 0 ? "" : " ") + std::to_string(i == face ? of_face : primitive->surfaces[i]);
  pending_.push_back(change_of(what, "paint", numbers));
}

// A number, -1 for none in common, among those that are described or in use nearby.
bool ModelPanel::choose_surface(const ModelDesk& desk, const char* label, std::int64_t& number) {
  const auto& surfaces = desk.interpreter().looks().surfaces;
  const auto told = [&](std::int64_t at) {
    const auto found = surfaces.find(at);
    return found == surfaces.end() ? std::to_string(at)
                                   : fmt::format("{}  {}", at, found->second.name);
  };
  const auto swatch = [&](std::int64_t at) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x + 2, corner.y + 2}, {corner.x + side - 1, corner.y + side - 1},
        ImGui::GetColorU32(shown_colour(colour_of(desk, at))), 2);
    ImGui::Dummy({side, side});
    ImGui::SameLine(0, 5);
  };
  const std::int64_t before = number;
  ImGui::PushID(label);
  const std::string shown = number >= 0 ? told(number) : "several";
  const bool open = ImGui::BeginCombo("##surface", "");
  note(label);
  if (open) {
    std::int64_t typed = number;
    ImGui::SetNextItemWidth(110);
    if (ImGui::InputScalar("number", ImGuiDataType_S64, &typed, nullptr, nullptr, "%lld",
                           ImGuiInputTextFlags_EnterReturnsTrue) &&
        typed >= 0) {
      number = typed;
      ImGui::CloseCurrentPopup();
    }
    note("surface number");
    std::vector<std::int64_t> known;
    for (const auto& [at, surface] : surfaces) known.push_back(at);
    for (std::int64_t at = 1; surfaces.empty() && at <= 8; ++at) known.push_back(at);
    for (const std::int64_t at : known) {
      ImGui::PushID(std::to_string(at).c_str());
      if (ImGui::Selectable("##number", at == number)) number = at;
      note(fmt::format("surface {}", at));
      ImGui::SameLine(0, 0);
      swatch(at);
      ImGui::TextUnformatted(told(at).c_str());
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  name_in_list(shown);
  ImGui::PopID();
  return number != before;
}

}  // namespace sir::viewer
