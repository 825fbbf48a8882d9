#include "viewer/file_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <system_error>
#include <utility>

#include "viewer/model_fields.h"
#include "viewer/model_style.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPopup = "###file dialog";
constexpr float kWidth = 620, kHeight = 460;

}  // namespace

void FileDialog::open(Wanted wanted, const fs::path& folder) {
  wanted_ = std::move(wanted);
  opening_ = true;
  go_to(!folder.empty() ? folder : listing_.folder.empty() ? fs::path(".") : listing_.folder);
  name(wanted_->proposed);
}

void FileDialog::draw(const Note& note) {
  if (!wanted_) return;
  const std::string title = wanted_->title + kPopup;
  if (std::exchange(opening_, false)) ImGui::OpenPopup(title.c_str());
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({io.DisplaySize.x / 2, io.DisplaySize.y / 2}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(kWidth, io.DisplaySize.x), std::min(kHeight, io.DisplaySize.y)});
  bool open = true;
  if (!ImGui::BeginPopupModal(title.c_str(), &open,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    wanted_.reset();
    return;
  }
  dim_around();
  draw_folder(note);
  draw_entries(note);
  if (replaced_) draw_question(note);
  else draw_name(note);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (escaped && replaced_) {
    replaced_.reset();
    to_name_ = true;
  } else if (escaped || !open) {
    wanted_.reset();
  }
  if (!wanted_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

// Each folder on the way down is a button.
void FileDialog::draw_folder(const Note& note) {
  fs::path wanted, whole;
  if (ImGui::Button("Up") && listing_.folder.has_parent_path())
    wanted = listing_.folder.parent_path();
  note("Up");
  std::vector<fs::path> steps;
  for (const fs::path& step : listing_.folder) steps.push_back(step);
  const float right = ImGui::GetWindowContentRegionMax().x;
  // As many of the last ones as there is room for.
  float room = right - ImGui::GetCursorPosX() - ImGui::CalcTextSize("Up ...").x - 40;
  std::size_t first = steps.size();
  while (first > 0) {
    room -= ImGui::CalcTextSize(readable(steps[first - 1].native()).c_str()).x + 12;
    if (room < 0) break;
    --first;
  }
  first = std::min(first, steps.size() - 1);
  ImGui::PushStyleColor(ImGuiCol_Button, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3, 3});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    whole /= steps[i];
    if (i < first) continue;
    ImGui::SameLine(0, 2);
    if (i > first && i > 1) {
      ImGui::TextDisabled("/");
      ImGui::SameLine(0, 2);
    }
    ImGui::PushID(static_cast<int>(i));
    if (name_button(readable(steps[i].native()))) wanted = whole;
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (!wanted.empty()) go_to(wanted);
}

void FileDialog::draw_entries(const Note& note) {
  fs::path folder;
  bool accepted = false;
  ImGui::BeginChild("entries", {0, -2 * ImGui::GetFrameHeightWithSpacing() - 2}, true);
  if (!listing_.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kAlarm);
    ImGui::TextWrapped("%s", listing_.error.c_str());
    ImGui::PopStyleColor();
  } else if (listing_.entries.empty()) {
    ImGui::TextDisabled("nothing of the kind here");
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(listing_.entries.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const FolderEntry& entry = listing_.entries[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      const bool chosen = !entry.folder && entry.shown == name_.data();
      const bool twice = ImGui::GetIO().MouseClickedLastCount[0] > 1;
      if (ImGui::Selectable("##entry", chosen, ImGuiSelectableFlags_DontClosePopups)) {
        // Who opens a folder by two clicks means nothing by the second, which is in it already.
        if (chosen && twice) accepted = true;
        else if (!twice && entry.folder) folder = listing_.folder / entry.name;
        else if (!twice) name(entry.shown);
      }
      note("\"" + entry.shown + "\"");
      ImGui::SameLine(0, 0);
      ImGui::TextColored(entry.folder ? kAccent : ImGui::GetStyleColorVec4(ImGuiCol_Text), "%s%s",
                         entry.shown.c_str(), entry.folder ? "/" : "");
      ImGui::PopID();
    }
  ImGui::EndChild();
  if (!folder.empty()) go_to(folder);
  if (accepted) accept();
}

void FileDialog::draw_name(const Note& note) {
  if (!wanted_) return;
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(to_name_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::PushID(names_);  // another field for every name, or one that is being edited would stay
  bool accepted = ImGui::InputTextWithHint(
      "##name", "name", name_.data(), name_.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopID();
  note("file name");
  if (error_.empty()) {
    std::string kinds;
    for (const std::string& suffix : wanted_->suffixes)
      kinds += (kinds.empty() ? "." : ", .") + suffix;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", kinds.c_str());
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(kAlarm, "%s", error_.c_str());
  }
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 176);
  const std::string label = wanted_->button + "##file";
  push_main_button();
  accepted |= ImGui::Button(label.c_str(), {84, 0});
  pop_main_button();
  note(label);
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {84, 0})) wanted_.reset();
  note("Cancel");
  if (accepted && wanted_) accept();
}

void FileDialog::draw_question(const Note& note) {
  ImGui::TextColored(kAlarm, "%s is there already.",
                     readable(as_written(*replaced_).native()).c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Replace it?");
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 176);
  const bool replace = ImGui::Button("Replace", {84, 0});
  note("Replace");
  ImGui::SameLine();
  if (ImGui::Button("Keep it", {84, 0})) {
    replaced_.reset();
    to_name_ = true;
  }
  note("Keep it");
  if (replace) finish(fs::path(*replaced_));
}

void FileDialog::go_to(fs::path folder) {
  static const std::vector<std::string> all;
  listing_ = list_folder(folder, wanted_ ? wanted_->suffixes : all);
  replaced_.reset();
  error_.clear();
  to_name_ = true;
}

void FileDialog::name(const std::string& text) {
  const std::size_t size = std::min(text.size(), name_.size() - 1);
  std::memcpy(name_.data(), text.data(), size);
  name_[size] = 0;
  ++names_;
  error_.clear();
  to_name_ = true;
}

void FileDialog::accept() {
  const std::string typed = name_.data();
  if (typed.empty()) {
    error_ = "a name is wanted";
    to_name_ = true;
    return;
  }
  const fs::path plain = named_in(listing_, typed);
  std::error_code ignored;
  if (fs::is_directory(plain, ignored)) {
    go_to(plain);
    name("");
    return;
  }
  const fs::path file = with_one_of(plain, wanted_->suffixes);
  const bool there = fs::exists(file, ignored);
  if (!wanted_->to_save && !there) {
    error_ = "there is no " + readable(file.filename().native()) + " here";
    to_name_ = true;
  } else if (wanted_->to_save && there) {
    replaced_ = file;
  } else {
    finish(file);
  }
}

void FileDialog::finish(const fs::path& file) {
  const auto chosen = std::move(wanted_->chosen);
  listing_.folder = file.parent_path();  // the next one begins there
  wanted_.reset();
  replaced_.reset();
  chosen(file);
}

}  // namespace sir::viewer
