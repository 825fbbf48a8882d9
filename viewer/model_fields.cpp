#include "viewer/model_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

constexpr float kLabels = 90;  // the width of their column

double rounded(float value) { return std::round(double(value) * 1000) / 1000; }

}  // namespace

void field_label(const char* label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(kQuiet, "%s", label);
  ImGui::SameLine(kLabels + ImGui::GetStyle().WindowPadding.x);
}

bool number_field(const NumberField& field, double* values, int count) {
  field_label(field.label);
  ImGui::PushID(field.label);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width);
  const bool changed =
      ImGui::DragScalarN("##numbers", ImGuiDataType_Double, values, count,
                         static_cast<float>(field.speed), nullptr, nullptr, field.format);
  ImGui::PopID();
  if (!field.along_axes) return changed;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float step = (high.x - low.x + ImGui::GetStyle().ItemInnerSpacing.x) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    const float x = std::floor(low.x + step * static_cast<float>(axis));
    ImGui::GetWindowDrawList()->AddRectFilled({x, low.y + 2}, {x + 2, high.y - 2},
                                              axis_colour(axis, false));
  }
  return changed;
}

bool colour_field(const char* label, glm::dvec3& colour) {
  field_label(label);
  ImGui::PushID(label);
  ImGui::BeginGroup();
  std::array<float, 3> shown{static_cast<float>(colour.x), static_cast<float>(colour.y),
                             static_cast<float>(colour.z)};
  bool changed = ImGui::ColorEdit3(
      "##swatch", shown.data(),
      ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_Float);
  if (changed) colour = {rounded(shown[0]), rounded(shown[1]), rounded(shown[2])};
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const double least = 0;
  changed |= ImGui::DragScalarN("##numbers", ImGuiDataType_Double, &colour.x, 3, 0.005f, &least,
                                nullptr, "%.3f", ImGuiSliderFlags_None);
  ImGui::EndGroup();
  ImGui::PopID();
  return changed;
}

bool name_button(const std::string& name) {
  const ImVec2 margin = ImGui::GetStyle().FramePadding;
  const ImVec2 size = ImGui::CalcTextSize(name.c_str());
  const bool pressed =
      ImGui::Button("##name button", {size.x + 2 * margin.x, size.y + 2 * margin.y});
  const ImVec2 corner = ImGui::GetItemRectMin();
  ImGui::GetWindowDrawList()->AddText({corner.x + margin.x, corner.y + margin.y},
                                      ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
  return pressed;
}

void name_in_list(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 margin = ImGui::GetStyle().FramePadding;
  ImGui::PushClipRect(low, {high.x - ImGui::GetFrameHeight(), high.y}, true);
  ImGui::GetWindowDrawList()->AddText({low.x + margin.x, low.y + margin.y},
                                      ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
  ImGui::PopClipRect();
}

bool chip(const char* label, bool on, const char* tip) {
  if (on) {
    push_main_button();
  } else {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                          ImGui::GetStyleColorVec4(ImGuiCol_FrameBgHovered));
  }
  const bool pressed = ImGui::Button(label);
  pop_main_button();
  if (tip != nullptr && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
  return pressed;
}

void draw_icon(const modeler::Node& node, const ImVec2& corner, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float size = ImGui::GetTextLineHeight();
  const auto at = [&](float x, float y) {
    return ImVec2(corner.x + x * size, corner.y + y * size);
  };
  if (const auto* composite = node.composite()) {
    const ImVec2 left = at(0.34f, 0.5f), right = at(0.66f, 0.5f);
    const float radius = 0.3f * size;
    const ImU32 faint = (colour & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 70);
    const bool both = composite->operation == Operation::union_of;
    const bool shared = composite->operation == Operation::intersection;
    if (!shared) list.AddCircleFilled(left, radius, colour, 14);
    else list.AddCircle(left, radius, faint, 14, 1.5f);
    if (both) list.AddCircleFilled(right, radius, colour, 14);
    else if (shared) list.AddCircle(right, radius, faint, 14, 1.5f);
    else list.AddCircleFilled(right, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 14);
    if (!both && !shared) list.AddCircle(right, radius, faint, 14, 1.5f);
    if (shared) {
      // The lens that both circles share.
      const float half = std::acos(0.16f / 0.3f);
      list.PathArcTo(left, radius, -half, half, 8);
      list.PathArcTo(right, radius, 3.14159265f - half, 3.14159265f + half, 8);
      list.PathFillConvex(colour);
    }
    return;
  }
  switch (node.primitive()->kind) {
    case PrimitiveKind::cube:
      list.AddRectFilled(at(0.15f, 0.2f), at(0.8f, 0.85f), colour, 1);
      break;
    case PrimitiveKind::sphere:
      list.AddCircleFilled(at(0.5f, 0.52f), 0.36f * size, colour, 16);
      break;
    case PrimitiveKind::cone:
      list.AddTriangleFilled(at(0.5f, 0.1f), at(0.9f, 0.86f), at(0.1f, 0.86f), colour);
      break;
    case PrimitiveKind::cylinder:
      list.AddRectFilled(at(0.26f, 0.14f), at(0.74f, 0.88f), colour, 0.2f * size);
      break;
  }
}

ImVec4 shown_colour(const glm::dvec3& colour) {
  const auto part = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  return {part(colour.x), part(colour.y), part(colour.z), 1};
}

std::string fitting(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string cut = text;
  while (!cut.empty() && ImGui::CalcTextSize((cut + "...").c_str()).x > width) {
    cut.pop_back();
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
    if (!cut.empty() && static_cast<unsigned char>(cut.back()) >= 0xC0) cut.pop_back();
  }
  return cut + "...";
}

ImU32 axis_colour(int axis, bool bright) {
  switch (axis) {
    case 0: return bright ? IM_COL32(255, 150, 140, 255) : IM_COL32(232, 84, 76, 255);
    case 1: return bright ? IM_COL32(170, 245, 150, 255) : IM_COL32(104, 196, 84, 255);
    case 2: return bright ? IM_COL32(160, 205, 255, 255) : IM_COL32(80, 148, 240, 255);
    default: return bright ? IM_COL32(255, 255, 255, 255) : IM_COL32(214, 214, 220, 255);
  }
}

}  // namespace sir::viewer
