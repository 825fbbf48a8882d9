#include "viewer/prompt.h"

#include <algorithm>
#include <charconv>

namespace sir::viewer {
namespace {

constexpr std::string_view kBetween = " ,;x";

// Takes the number that the text begins with, after what may stand between two.
std::optional<int> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBetween), text.size()));
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

}  // namespace

void Prompt::ask(Kind kind) {
  kind_ = kind;
  text_.clear();
  find();
}

void Prompt::type(std::string_view text) {
  text_ += text;
  find();
}

bool Prompt::press(const Key& key) {
  switch (key.code) {
    case kBackspace:
      // A character of UTF-8 ends with its first byte, going back.
      while (!text_.empty() && (text_.back() & 0xC0) == 0x80) text_.pop_back();
      if (!text_.empty()) text_.pop_back();
      find();
      return true;
    case kUp:
      if (chosen_ > 0) --chosen_;
      return true;
    case kDown:
      if (chosen_ + 1 < found_.size()) ++chosen_;
      return true;
    default: return false;
  }
}

void Prompt::find() {
  chosen_ = 0;
  found_.clear();
  if (kind_ == Kind::command) found_ = find_commands(text_);
}

std::optional<Command> Prompt::command() const {
  if (kind_ != Kind::command || chosen_ >= found_.size()) return std::nullopt;
  return found_[chosen_]->command;
}

std::optional<Place> Prompt::pixel() const {
  if (kind_ != Kind::pixel) return std::nullopt;
  std::string_view rest = text_;
  const auto x = take_number(rest), y = take_number(rest);
  if (!x || !y || rest.find_first_not_of(' ') != std::string_view::npos) return std::nullopt;
  return Place{*x, *y};
}

}  // namespace sir::viewer
