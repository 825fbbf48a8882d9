#include "viewer/model_offer.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "modeler/command_line.h"
#include "tracer/text_file.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

constexpr const char* kPopup = "A session was not ended###offer";
constexpr float kWidth = 560, kButton = 120;
constexpr std::size_t kToldFiles = 5;  // that have changed

}  // namespace

void ModelOffer::open(std::vector<modeler::KeptSession> sessions) {
  sessions_ = std::move(sessions);
  opening_ = !sessions_.empty();
}

std::optional<std::string> ModelOffer::draw(
    const std::function<void(const std::string& label)>& note) {
  if (sessions_.empty()) return std::nullopt;
  if (std::exchange(opening_, false)) ImGui::OpenPopup(kPopup);
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(kWidth, all.x), 0});
  if (!ImGui::BeginPopupModal(kPopup, nullptr,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    sessions_.clear();
    return std::nullopt;
  }
  dim_around();
  const modeler::KeptSession& last = sessions_.front();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(modeler::text_of(last).c_str());
  for (std::size_t i = 0; i < std::min(last.changed.size(), kToldFiles); ++i)
    ImGui::TextColored(kAlarm, "%s has changed since; it is taken as it was read then",
                       visible(last.changed[i]).c_str());
  if (last.changed.size() > kToldFiles)
    ImGui::TextColored(kAlarm, "and %zu more", last.changed.size() - kToldFiles);
  if (sessions_.size() > 1) ImGui::TextDisabled("%zu more are kept", sessions_.size() - 1);
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const auto button = [&](const char* label) {
    const bool pressed = ImGui::Button(label, {kButton, 0});
    note(label);
    return pressed;
  };
  std::optional<std::string> line;
  bool done = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  push_main_button();
  const bool recover = button("Recover");
  pop_main_button();
  ImGui::SameLine();
  done |= button("Keep for later");
  ImGui::SameLine();
  if (button("Discard")) {
    line = "recover --discard " + modeler::as_word(last.name);
    sessions_.erase(sessions_.begin());
    done = sessions_.empty();
  } else if (recover) {
    line = "recover " + modeler::as_word(last.name);
    done = true;
  }
  if (done) {
    sessions_.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  return line;
}

}  // namespace sir::viewer
