#include "viewer/panel_lut.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "viewer/argb.h"

namespace sir::viewer {
namespace {

constexpr int kFieldsAcross = 16;

ImU32 colour_of(Rgb8 colour) { return IM_COL32(colour.r, colour.g, colour.b, 255); }

std::string entry_text(const Rendition& rendition, const LutUsage* usage, std::size_t index) {
  const auto& code = rendition.lut.entry[index];
  const Rgb8 seen = rendition.lut.seen(index);
  const auto three = [](int a, int b, int c) {
    return std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c);
  };
  return "entry " + std::to_string(index) + ": codes " + three(code[0], code[1], code[2]) +
         ", seen " + three(seen.r, seen.g, seen.b) + "\n" +
         (usage != nullptr ? std::to_string(usage->pixels[index]) : "...") + " pixels";
}

}  // namespace

void LutPart::draw(Viewer& viewer) {
  const int which = viewer.active_side();
  const auto rendition = viewer.side(which).rendition();
  if (!rendition) {
    viewer.hover_entry(std::nullopt);
    return ImGui::TextDisabled("...");
  }
  const LutUsage* usage = viewer.findings().usage(which);
  draw_order();
  draw_fields(viewer, *rendition, usage);
  const auto entry = viewer.entry();
  const std::string text = entry ? entry_text(*rendition, usage, *entry)
                                 : "point at an entry to see its pixels;\na click keeps them shown";
  ImGui::TextUnformatted(text.c_str());
  if (usage == nullptr) return ImGui::TextDisabled("...");
  ImGui::TextDisabled("%zu entries unused, %zu seen as an earlier one", usage->unused,
                      usage->repeated);
}

void LutPart::draw_order() {
  constexpr std::array kOrders{"LUT order", "by pixels", "by hue", "by lightness"};
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##order", kOrders[static_cast<std::size_t>(order_)])) return;
  for (std::size_t i = 0; i < kOrders.size(); ++i)
    if (ImGui::Selectable(kOrders[i], order_ == static_cast<EntryOrder>(i)))
      order_ = static_cast<EntryOrder>(i);
  ImGui::EndCombo();
}

void LutPart::draw_fields(Viewer& viewer, const Rendition& rendition, const LutUsage* usage) {
  const auto order = entry_order(rendition.lut, usage != nullptr ? *usage : LutUsage{}, order_);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side =
      static_cast<float>(static_cast<int>(ImGui::GetContentRegionAvail().x / kFieldsAcross));
  const float whole = side * kFieldsAcross;
  ImGui::InvisibleButton("fields", {whole, whole});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::optional<std::uint8_t> under_mouse;
  const ImVec2 mouse = ImGui::GetMousePos();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ImVec2 from{corner.x + side * static_cast<float>(i % kFieldsAcross),
                      corner.y + side * static_cast<float>(i / kFieldsAcross)};
    const ImVec2 to{from.x + side - 1, from.y + side - 1};
    const std::uint8_t entry = order[i];
    list.AddRectFilled(from, to, colour_of(rendition.lut.seen(entry)));
    if (usage != nullptr && usage->pixels[entry] == 0)  // nobody would miss it
      list.AddRectFilled({to.x - 3, to.y - 3}, to, colour_of({128, 128, 128}));
    if (hovered && mouse.x >= from.x && mouse.y >= from.y && mouse.x < from.x + side &&
        mouse.y < from.y + side)
      under_mouse = entry;
    if (viewer.pinned_entry() == entry || under_mouse == entry)
      list.AddRect(from, to, IM_COL32(255, 200, 87, 255), 0, 0, 2);
  }
  viewer.hover_entry(under_mouse);
  if (under_mouse && ImGui::IsItemClicked())
    viewer.pin_entry(viewer.pinned_entry() == under_mouse ? std::nullopt : under_mouse);
}

}  // namespace sir::viewer
