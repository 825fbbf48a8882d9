// What is to become of sessions that were not ended: the question with which the modeler's window
// opens (the thesis has none). Only in builds with Dear ImGui.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "modeler/kept_sessions.h"

namespace sir::viewer {

/// A dialog over the whole window. It asks of the last session first; of the one before where that
/// is discarded.
class ModelOffer {
 public:
  /// Begins with the next drawing, where there are any.
  void open(std::vector<modeler::KeptSession> sessions);

  /// Draws it where it is open; the command that a person chose. `note` hears of every button.
  std::optional<std::string> draw(const std::function<void(const std::string& label)>& note);

 private:
  std::vector<modeler::KeptSession> sessions_;
  bool opening_ = false;
};

}  // namespace sir::viewer
