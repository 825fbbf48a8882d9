#include "viewer/panel_parts.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/judgement.h"

namespace sir::viewer {
namespace {

const ImVec4 kAlarm{1.0f, 0.45f, 0.35f, 1.0f};

void lines(const std::vector<std::string>& text) {
  ImGui::PushTextWrapPos(0);  // at the panel's edge
  for (const std::string& line : text) ImGui::TextUnformatted(line.c_str());
  ImGui::PopTextWrapPos();
}

// A button for each command, the chosen one marked.
void button(Viewer& viewer, const char* label, Command command, bool chosen) {
  if (chosen)
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  if (ImGui::Button(label)) viewer.perform(command);
  if (chosen) ImGui::PopStyleColor();
}

}  // namespace

void PanelParts::draw(Viewer& viewer) {
  const auto part = [](const char* name) {
    return ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
  };
  if (viewer.player() != nullptr) {
    if (part("Register trace")) draw_trace(viewer);
    if (part("Inspector")) draw_inspector(viewer);
    return;
  }
  if (part("Colours")) draw_colours(viewer);
  if (part("The MA120")) draw_machine(viewer);
  if (part("LUT")) lut_.draw(viewer);
  else viewer.hover_entry(std::nullopt);
  if (part("Inspector: why this colour")) draw_inspector(viewer);
  if (part("On the screen")) draw_judgement(viewer);
  if (part("Histogram")) draw_histogram(viewer);
}

void PanelParts::draw_colours(Viewer& viewer) {
  const Method now = viewer.side(viewer.active_side()).shown_method();
  const auto method = [&](const char* label, Command command, Method which) {
    button(viewer, label, command, now == which);
  };
  method("True colour", Command::true_colour, Method::true_colour);
  ImGui::SameLine();
  method("LUT file", Command::lut_file, Method::lut_file);
  ImGui::SameLine();
  method("Best", Command::best, Method::best);
  method("RGB median", Command::rgb_median, Method::rgb_median);
  ImGui::SameLine();
  method("RGB frequency", Command::rgb_frequency, Method::rgb_frequency);
  method("HSV median", Command::hsv_median, Method::hsv_median);
  ImGui::SameLine();
  method("HSV frequency", Command::hsv_frequency, Method::hsv_frequency);
  button(viewer, "Heat map", Command::heat_map, viewer.map() == Map::heat);
  ImGui::SameLine();
  button(viewer, "Duel", Command::split, viewer.duel());
  ImGui::SameLine();
  button(viewer, "Who wins", Command::duel_map, viewer.map() == Map::duel);
  if (viewer.duel()) {
    ImGui::SameLine();
    button(viewer, viewer.active_side() == 0 ? "Side A" : "Side B", Command::other_side, true);
  }
  lines(viewer.tally());
}

void PanelParts::draw_machine(Viewer& viewer) {
  for (int plane = 0; plane < 8; ++plane) {
    bool on = ((viewer.planes() >> plane) & 1) != 0;
    if (ImGui::Checkbox(std::to_string(plane + 1).c_str(), &on))
      viewer.perform(static_cast<Command>(static_cast<int>(Command::plane_1) + plane));
    if (plane % 4 != 3) ImGui::SameLine();
  }
  button(viewer, "All planes", Command::all_planes, viewer.planes() == 0xFF);
  ImGui::SameLine();
  button(viewer, "Lift mask", Command::read_mask, viewer.mask_lifted());
  ImGui::SameLine();
  button(viewer, "CRT", Command::crt, viewer.crt_on());
}

void PanelParts::draw_histogram(Viewer& viewer) {
  const Side& side = viewer.side(viewer.active_side());
  if (!side.picture() || !side.rendition()) return;
  ImGui::RadioButton("red", &primary_, 0);
  ImGui::SameLine();
  ImGui::RadioButton("green", &primary_, 1);
  ImGui::SameLine();
  ImGui::RadioButton("blue", &primary_, 2);
  const auto* before = viewer.findings().histogram_before(viewer.active_side());
  const auto* after = viewer.findings().histogram_after(viewer.active_side());
  if (before == nullptr || after == nullptr) return ImGui::TextDisabled("...");
  const auto plot = [&](const char* id, const char* label, const PrimaryHistogram& histogram) {
    const auto& bins = histogram[static_cast<std::size_t>(primary_)];
    std::vector<float> values(bins.size());
    std::transform(bins.begin(), bins.end(), values.begin(),
                   [](std::uint64_t pixels) { return static_cast<float>(pixels); });
    ImGui::PlotHistogram(id, values.data(), static_cast<int>(values.size()), 0, label, 0,
                         *std::max_element(values.begin(), values.end()),
                         {ImGui::GetContentRegionAvail().x, 60});
  };
  plot("##before", "true colours", *before);
  plot("##after", "as seen", *after);
}

void PanelParts::draw_judgement(Viewer& viewer) {
  const int which = viewer.active_side();
  if (viewer.side(which).true_colour()) return ImGui::TextDisabled("the reference itself");
  const Judgement* judgement = viewer.findings().judgement(which);
  if (judgement == nullptr) return ImGui::TextDisabled("judging ...");
  if (!judgement->lost.empty()) {
    std::string alarm = "HUES LOST:";
    for (const LostHue& hue : judgement->lost)
      alarm.append(" ").append(hue.name).append(" (" + std::to_string(hue.degrees) + "°)");
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(kAlarm, "%s", alarm.c_str());
    ImGui::PopTextWrapPos();
  }
  lines(describe(*judgement));
}

void PanelParts::draw_inspector(Viewer& viewer) { lines(viewer.inspection()); }

void PanelParts::draw_trace(Viewer& viewer) {
  const eltek::TracePlayer& player = *viewer.player();
  int at = static_cast<int>(player.position());
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##record", &at, 0, static_cast<int>(player.count()), "record %d"))
    viewer.seek(static_cast<std::size_t>(at));
  for (const auto& [label, command] :
       {std::pair{"|<", Command::trace_start}, std::pair{"<<", Command::leap_back},
        std::pair{"<", Command::step_back}, std::pair{">", Command::step_forward},
        std::pair{">>", Command::leap_forward}, std::pair{">|", Command::trace_end}}) {
    button(viewer, label, command, false);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  ImGui::Text("beam at line %d", player.raster().position().line());
  // The records around the one that was played last, which is marked.
  constexpr std::size_t kAround = 8;
  const std::size_t last = player.position();
  const std::size_t first = last > kAround ? last - kAround : 0;
  for (std::size_t i = first; i < std::min(last + kAround, player.count()); ++i) {
    const std::string line = std::to_string(i + 1) + "  " + player.describe(i);
    if (i + 1 == last) ImGui::TextColored({1.0f, 0.78f, 0.34f, 1.0f}, "%s", line.c_str());
    else if (i < last) ImGui::TextUnformatted(line.c_str());
    else ImGui::TextDisabled("%s", line.c_str());
  }
}

}  // namespace sir::viewer
