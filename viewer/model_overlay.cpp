#include "viewer/model_overlay.h"

#include <cmath>
#include <vector>

#include "viewer/model_fields.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

constexpr float kGrip = 5;  // half the side of a grip
const ImU32 kShade = IM_COL32(0, 0, 0, 150);

}  // namespace

ImVec2 ModelOverlay::place(const glm::dvec2& at) const {
  const glm::dvec2 unit = (corner_ + at) / density_;
  return {static_cast<float>(unit.x), static_cast<float>(unit.y)};
}

void ModelOverlay::draw(const Handles& handles, std::optional<int> axis, bool held) const {
  for (const Handle& handle : handles.all()) {
    const bool bright = axis == handle.axis;
    if (held && !bright) continue;
    if (handle.axis != Handle::kAll) draw_line(handle, handles.kind(), bright);
  }
  for (const Handle& handle : handles.all()) {
    const bool bright = axis == handle.axis;
    if (handle.axis != Handle::kAll || (held && !bright)) continue;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 middle = place(handles.middle());
    list.AddCircleFilled(middle, kGrip + 1.5f, kShade, 20);
    list.AddCircleFilled(middle, kGrip, axis_colour(handle.axis, bright), 20);
  }
}

void ModelOverlay::draw_line(const Handle& handle, HandleKind kind, bool bright) const {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImU32 colour = axis_colour(handle.axis, bright);
  const float width = bright ? 3.0f : 2.0f;
  std::vector<ImVec2> points;
  for (const glm::dvec2& at : handle.line) points.push_back(place(at));
  const auto count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, kShade, ImDrawFlags_None, width + 2);
  list.AddPolyline(points.data(), count, colour, ImDrawFlags_None, width);
  const ImVec2 grip = points.back();
  if (kind == HandleKind::scale) {
    list.AddRectFilled({grip.x - kGrip - 1, grip.y - kGrip - 1},
                       {grip.x + kGrip + 1, grip.y + kGrip + 1}, kShade);
    list.AddRectFilled({grip.x - kGrip, grip.y - kGrip}, {grip.x + kGrip, grip.y + kGrip}, colour);
  } else if (kind == HandleKind::move) {
    const ImVec2 from = points.front();
    const float x = grip.x - from.x, y = grip.y - from.y, length = std::hypot(x, y);
    const ImVec2 along{x / length, y / length}, across{-along.y, along.x};
    const auto at = [&](float forth, float aside) {
      return ImVec2(grip.x + along.x * forth + across.x * aside,
                    grip.y + along.y * forth + across.y * aside);
    };
    list.AddTriangleFilled(at(10, 0), at(-5, kGrip + 2), at(-5, -kGrip - 2), kShade);
    list.AddTriangleFilled(at(8, 0), at(-4, kGrip), at(-4, -kGrip), colour);
  }
}

void ModelOverlay::tell(const std::string& text, const ImVec2& room) const {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::string shown = fitting(text, room.x - 28);
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 corner{8, room.y - size.y - 16};
  list.AddRectFilled(corner, {corner.x + size.x + 14, corner.y + size.y + 8},
                     IM_COL32(20, 21, 24, 225), 3);
  list.AddText({corner.x + 7, corner.y + 4}, ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
}

void ModelOverlay::invite(const std::string& text, const ImVec2& room) const {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetBackgroundDrawList()->AddText({(room.x - size.x) / 2, (room.y - size.y) / 2},
                                          ImGui::GetColorU32(kQuiet), text.c_str());
}

}  // namespace sir::viewer
