// A line that a person types into: the command palette and the way to a pixel. The thesis's
// programs asked on the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/commands.h"
#include "viewer/key.h"
#include "viewer/viewport.h"

namespace sir::viewer {

/// What is being asked, what was typed so far, and what may be chosen.
class Prompt {
 public:
  enum class Kind { none, command, pixel };

  bool open() const { return kind_ != Kind::none; }
  Kind kind() const { return kind_; }
  void ask(Kind kind);
  void close() { kind_ = Kind::none; }

  /// Adds UTF-8 text at the end.
  void type(std::string_view text);

  /// Backspace, Up and Down; other keys are not the prompt's. Returns whether it was one of them.
  bool press(const Key& key);

  const std::string& text() const { return text_; }

  /// Of Kind::command: those that match, and which of them Enter would take.
  const std::vector<const CommandInfo*>& found() const { return found_; }
  std::size_t chosen() const { return chosen_; }

  /// What Enter would do; none where nothing matches or it is something else that is asked.
  std::optional<Command> command() const;

  /// The pixel "x, y" that was typed, commas or blanks between; none for anything else.
  std::optional<Place> pixel() const;

 private:
  void find();

  Kind kind_ = Kind::none;
  std::string text_;
  std::vector<const CommandInfo*> found_;
  std::size_t chosen_ = 0;
};

}  // namespace sir::viewer
