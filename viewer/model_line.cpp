#include "viewer/model_line.h"

#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "modeler/completion.h"

namespace sir::viewer {
namespace {

constexpr std::size_t kMostOffered = 60;  // words that are told

void replace(ImGuiInputTextCallbackData* data, int from, const std::string& text) {
  data->DeleteChars(from, data->BufTextLen - from);
  data->InsertChars(from, text.data(), text.data() + text.size());
}

}  // namespace

std::optional<std::string> ModelLine::draw(const modeler::Interpreter& interpreter) {
  interpreter_ = &interpreter;
  if (std::exchange(to_line_, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint(
      "##command", "a command; Tab completes, arrows bring back", text_.data(), text_.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion |
          ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_CallbackEdit |
          ImGuiInputTextFlags_CallbackAlways,
      answer, this);
  interpreter_ = nullptr;
  if (!entered) return std::nullopt;
  std::string line = text_.data();
  text_[0] = 0;
  offered_.clear();
  to_line_ = true;
  if (line.empty()) return std::nullopt;
  if (earlier_.empty() || earlier_.back() != line) earlier_.push_back(line);
  at_ = earlier_.size();
  return line;
}

void ModelLine::propose(const std::string& text) {
  proposed_ = text.substr(0, text_.size() - 1);
  std::copy_n(proposed_->c_str(), proposed_->size() + 1, text_.data());
  at_ = earlier_.size();
  offered_.clear();
  to_line_ = true;
}

int ModelLine::answer(ImGuiInputTextCallbackData* data) {
  auto& line = *static_cast<ModelLine*>(data->UserData);
  switch (data->EventFlag) {
    case ImGuiInputTextFlags_CallbackCompletion: line.complete(data); break;
    case ImGuiInputTextFlags_CallbackHistory: line.recall(data); break;
    case ImGuiInputTextFlags_CallbackEdit: line.offered_.clear(); break;
    default:
      // While it has the keyboard, what it shows is its own copy of the text.
      if (line.proposed_) {
        replace(data, 0, *std::exchange(line.proposed_, std::nullopt));
        data->ClearSelection();
      }
      break;
  }
  return 0;
}

void ModelLine::complete(ImGuiInputTextCallbackData* data) {
  const std::string_view line(data->Buf, static_cast<std::size_t>(data->CursorPos));
  if (data->CursorPos != data->BufTextLen) return;
  const modeler::Completion completion = modeler::complete(*interpreter_, line);
  const auto begin = static_cast<int>(completion.begin);
  if (completion.words.empty()) return;
  const std::string start = modeler::common_start(completion.words);
  const bool only = completion.words.size() == 1;
  // A folder's name goes on.
  const std::string text = only && !start.ends_with('/') ? start + " " : start;
  if (text.size() > line.size() - completion.begin || only) replace(data, begin, text);
  offered_.clear();
  if (only) return;
  // A line each where there is something to be said of them.
  const bool noted = !completion.notes.empty();
  const char* between = noted ? "\n" : "   ";
  for (std::size_t i = 0; i < completion.words.size() && i < kMostOffered; ++i)
    offered_ +=
        (i == 0 ? "" : between) + completion.words[i] + (noted ? "  " + completion.notes[i] : "");
  if (completion.words.size() > kMostOffered)
    offered_ += between + std::string("and ") +
                std::to_string(completion.words.size() - kMostOffered) + " more";
}

void ModelLine::recall(ImGuiInputTextCallbackData* data) {
  if (at_ == earlier_.size())
    written_.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  if (data->EventKey == ImGuiKey_UpArrow && at_ > 0) --at_;
  else if (data->EventKey == ImGuiKey_DownArrow && at_ < earlier_.size()) ++at_;
  else return;
  replace(data, 0, at_ == earlier_.size() ? written_ : earlier_[at_]);
}

}  // namespace sir::viewer
