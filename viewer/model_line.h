// The line for commands in the modeler's window, as at the prompt: what has been typed comes back
// with the arrows, Tab completes. Only in builds with Dear ImGui.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "modeler/interpreter.h"

struct ImGuiInputTextCallbackData;

namespace sir::viewer {

class ModelLine {
 public:
  /// Draws it; the line that was entered, if one was. It keeps the keyboard then.
  std::optional<std::string> draw(const modeler::Interpreter& interpreter);

  /// Puts a text there to be changed or entered.
  void propose(const std::string& text);

  /// What could stand where the line ends, after a Tab that left it open; "" else.
  const std::string& offered() const { return offered_; }

 private:
  static int answer(ImGuiInputTextCallbackData* data);
  void complete(ImGuiInputTextCallbackData* data);
  void recall(ImGuiInputTextCallbackData* data);

  std::array<char, 4096> text_{};
  std::vector<std::string> earlier_;
  std::size_t at_ = 0;   // among the earlier ones; their number: none of them
  std::string written_;  // what stood there before the first arrow
  std::string offered_;
  std::optional<std::string> proposed_;
  bool to_line_ = false;
  const modeler::Interpreter* interpreter_ = nullptr;  // while it is drawn
};

}  // namespace sir::viewer
