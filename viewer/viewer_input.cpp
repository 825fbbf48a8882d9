// Keys, text and mouse on their way to the viewer's commands.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "viewer/viewer.h"

namespace sir::viewer {
namespace {

// So near to the line, in window pixels, a press takes hold of it.
constexpr int kGrip = 5;
// A hand that clicks moves less than that.
constexpr int kClick = 3;

bool is_arrow(const Key& key) { return key.code >= kLeft && key.code <= kDown; }

}  // namespace

bool Viewer::press(const Key& key) {
  stale_ = true;
  if (prompt_.open()) {
    key_taken_ = false;
    if (key.code == kEscape) prompt_.close();
    else if (key.code == kEnter) answer_prompt();
    else return prompt_.press(key);
    return true;
  }
  const auto command = command_for(key);
  key_taken_ = command && !key.ctrl && !key.alt && key.code < kFirstNamedKey;
  if (!command) return false;
  message_.clear();
  if (is_arrow(key) && inspector_open_) arrow(key);
  else if (*command == Command::flip_reference) hold_reference(true);
  else perform(*command);
  return true;
}

void Viewer::release(const Key& key) {
  key_taken_ = false;
  // Whatever else went down meanwhile.
  if (command_for(Key{.code = key.code}) == Command::flip_reference) hold_reference(false);
}

void Viewer::hold_reference(bool held) {
  if (held == reference_held_ || player_) return;
  reference_held_ = held;
  composed_ = false;
  stale_ = true;
}

void Viewer::arrow(const Key& key) {
  const int length = key.shift ? 10 : 1;
  switch (key.code) {
    case kLeft: return nudge(-length, 0);
    case kRight: return nudge(length, 0);
    case kUp: return nudge(0, -length);
    default: return nudge(0, length);
  }
}

void Viewer::type(std::string_view text) {
  // The character of a key that was for something already.
  if (std::exchange(key_taken_, false)) return;
  stale_ = true;
  if (prompt_.open()) return prompt_.type(text);
  const bool letter = text.size() == 1 && std::isalnum(static_cast<unsigned char>(text[0])) != 0;
  if (letter || text == " ") return;
  if (const auto key = parse_key(text)) press(*key);
  key_taken_ = false;
}

void Viewer::answer_prompt() {
  const auto command = prompt_.command();
  const auto pixel = prompt_.pixel();
  const bool asked_pixel = prompt_.kind() == Prompt::Kind::pixel;
  const std::string text = prompt_.text();
  prompt_.close();
  message_.clear();
  if (command) perform(*command);
  else if (pixel) go_to(*pixel);
  else if (asked_pixel && !text.empty()) say("\"" + text + "\" is not a pixel such as 320, 200");
}

void Viewer::point(Place at) {
  mouse_ = at;
  stale_ = stale_ || inspector_open_ || panel_open_;
  if (!drag_from_) return;
  if (dragging_split_) {
    const Letterbox box = viewport_.box();
    const int m = viewport_.multiple();
    split_column_ = std::clamp((at.x - box.x + m / 2) / m, 0, viewport_.box().width / m);
    composed_ = false;
  } else if (dragged_ || std::abs(at.x - drag_from_->x) > kClick ||
             std::abs(at.y - drag_from_->y) > kClick) {
    dragged_ = true;
    viewport_.pan(at.x - drag_from_->x, at.y - drag_from_->y);
    drag_from_ = at;
  }
  stale_ = true;
}

void Viewer::press(Button button, Place at) {
  if (button == Button::right) return hold_reference(true);
  drag_from_ = at;
  dragged_ = false;
  dragging_split_ = false;
  if (button != Button::left || !duel_) return;
  const int line = viewport_.box().x + split_column_ * viewport_.multiple();
  dragging_split_ = std::abs(at.x - line) <= kGrip;
}

void Viewer::release(Button button, Place at) {
  if (button == Button::right) return hold_reference(false);
  const bool clicked = drag_from_ && !dragged_ && !dragging_split_ && button == Button::left;
  drag_from_.reset();
  dragging_split_ = false;
  if (!clicked) return;
  const auto pixel = viewport_.pixel_at(at);
  pinned_ = pixel == pinned_ ? std::nullopt : pixel;
  stale_ = true;
}

void Viewer::wheel(int steps, Place at) {
  mouse_ = at;
  zoom(steps, at);
  stale_ = true;
}

}  // namespace sir::viewer
