// The panel's part with the trees of composition (thesis 3.2.1).
#include <imgui.h>

#include <algorithm>

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/look_text.h"
#include "modeler/operations.h"
#include "modeler/view.h"
#include "tracer/names.h"
#include "viewer/model_fields.h"
#include "viewer/model_panel.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

constexpr const char* kSolid = "solid";
constexpr float kIndent = 14, kArrow = 15, kIcon = 20;
constexpr double kSeen = 0.5;         // of a colour's brightest primary, on the panel
constexpr std::size_t kDeepest = 14;  // levels that are indented; deeper ones stand there
constexpr std::size_t kMostRows = 10, kFewRows = 3;  // that are in sight at a time

std::string kind_of(const modeler::Node& node) {
  if (const auto* composite = node.composite()) return std::string(name_of(composite->operation));
  const modeler::Primitive& primitive = *node.primitive();
  const bool mixed = primitive.surface_per_face;
  return fmt::format("{} {}{}", name_of(primitive.kind), primitive.surfaces[0],
                     mixed ? " ..." : "");
}

}  // namespace

glm::dvec3 ModelPanel::colour_of(const ModelDesk& desk, std::int64_t number) const {
  const auto& surfaces = desk.interpreter().looks().surfaces;
  const auto found = surfaces.find(number);
  const Surface surface =
      found == surfaces.end() ? modeler::made_up_surface(number) : found->second;
  // What is glass or a mirror is all but black: it is lifted until it can be seen.
  const glm::dvec3& diffuse = surface.first.diffuse;
  const double brightest = std::max({diffuse.x, diffuse.y, diffuse.z});
  return brightest < kSeen ? diffuse + glm::dvec3(kSeen - brightest) : diffuse;
}

void ModelPanel::draw_solids(const ModelDesk& desk) {
  const modeler::Lsu& solids = desk.interpreter().solids();
  if (solids.empty()) return ImGui::TextDisabled("none yet: create one below, or open a file");
  const auto& selection = desk.interpreter().selection();
  if (reveal_ && selection) rows_.reveal(solids, selection->solid, selection->place);
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", fmt::format("filter {} by name", solids.size()).c_str(),
                           filter_.data(), filter_.size());
  note("filter");
  const std::vector<TreeRow> rows = rows_.rows(solids, filter_.data());
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const auto shown = static_cast<float>(std::clamp(rows.size(), kFewRows, kMostRows));
  ImGui::BeginChild("tree", {0, shown * line + 2 * ImGui::GetStyle().WindowPadding.y}, true);
  if (rows.empty()) ImGui::TextDisabled("no node has such a name");
  if (reveal_ && selection) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const TreeRow& row) {
      return row.place == selection->place && *row.solid == selection->solid;
    });
    const float top = static_cast<float>(found - rows.begin()) * line;
    const float height = ImGui::GetContentRegionAvail().y;
    if (found != rows.end() &&
        (top < ImGui::GetScrollY() || top + line > ImGui::GetScrollY() + height))
      ImGui::SetScrollY(std::max(0.0f, top - height / 2));
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), line);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      ImGui::PushID(i);
      draw_row(desk, rows[static_cast<std::size_t>(i)]);
      ImGui::PopID();
    }
  ImGui::EndChild();
}

void ModelPanel::draw_row(const ModelDesk& desk, const TreeRow& row) {
  const modeler::Node& node = *row.node;
  const auto& chosen = desk.interpreter().selection();
  const bool is_chosen = chosen && chosen->solid == *row.solid && chosen->place == row.place;
  const std::string& name = row.place == 0 ? *row.solid : node.name;
  const float height = ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       kIndent * static_cast<float>(std::min(row.depth, kDeepest)));
  const ImVec2 arrow = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##open", {kArrow, height}) && node.composite() != nullptr)
    rows_.set_open(*row.solid, row.place, !row.open);
  if (row.place == 0) note("open \"" + *row.solid + "\"");
  if (node.composite() != nullptr && filter_[0] == 0) {
    const ImU32 colour =
        ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    const auto at = [&](float x, float y) { return ImVec2(arrow.x + x, arrow.y + height / 2 + y); };
    if (row.open) list.AddTriangleFilled(at(2, -2), at(10, -2), at(6, 4), colour);
    else list.AddTriangleFilled(at(3, -4), at(9, 0), at(3, 4), colour);
  }
  ImGui::SameLine(0, 0);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleColor(ImGuiCol_Header, ImVec4(0.26f, 0.53f, 0.86f, 0.28f));
  const bool clicked = ImGui::Selectable("##row", is_chosen, 0, {0, height});
  ImGui::PopStyleColor();
  if (clicked)
    pending_.push_back(modeler::select_line(modeler::Selection{*row.solid, row.place, {}}));
  if (row.place == 0) note("\"" + *row.solid + "\"");
  else note("\"" + *row.solid + "\" " + std::to_string(row.place));
  if (row.place == 0) draw_drop(*row.solid);
  const ImVec4 colour = node.composite() != nullptr
                            ? kQuiet
                            : shown_colour(colour_of(desk, node.primitive()->surfaces[0]));
  draw_icon(node, corner, ImGui::GetColorU32(colour));
  const std::string kind = filter_[0] != 0 && row.place > 0 ? "of " + *row.solid : kind_of(node);
  const float tail = ImGui::CalcTextSize(kind.c_str()).x;
  const std::string shown = fitting(name, width - tail - kIcon - 12);
  list.AddText({corner.x + kIcon, corner.y},
               ImGui::GetColorU32(is_chosen ? kAccent : ImGui::GetStyleColorVec4(ImGuiCol_Text)),
               shown.c_str());
  list.AddText({corner.x + width - tail - 4, corner.y}, ImGui::GetColorU32(kQuiet), kind.c_str());
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

}  // namespace sir::viewer
