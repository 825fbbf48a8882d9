#include "viewer/model_hand.h"

#include <fmt/format.h>

#include <cmath>

#include "modeler/command_line.h"

namespace sir::viewer {
namespace {

// In units of the window.
constexpr double kLength = 84, kReach = 7;
constexpr const char* kAxes[]{"x", "y", "z"};

bool is_usable(const modeler::Box& box) {
  if (modeler::is_empty(box)) return false;
  const glm::dvec3 extent = box.high - box.low;
  return std::isfinite(extent.x) && std::isfinite(extent.y) && std::isfinite(extent.z);
}

}  // namespace

std::string change_of(const modeler::Selection& what, std::string_view verb,
                      std::string_view arguments) {
  const std::string solid = modeler::as_word(what.solid);
  return what.place == 0 ? fmt::format("{} {} {}", verb, solid, arguments)
                         : fmt::format("edit {} {} {} {}", solid, what.place, verb, arguments);
}

std::optional<Handles> ModelHand::handles(const ModelDesk& desk) const {
  const modeler::Node* node = desk.selected_node();
  if (!kind || node == nullptr || !is_usable(node->bounds)) return std::nullopt;
  return Handles(*kind, node->bounds.centre(), desk.camera(), desk.picture_size(),
                 kLength * density_);
}

bool ModelHand::press(const ModelDesk& desk, const glm::dvec2& at) {
  auto there = handles(desk);
  if (!there) return false;
  const auto axis = there->at(at, kReach * density_);
  if (!axis) return false;
  const modeler::Node& node = *desk.selected_node();
  const bool off_origin = node.primitive() != nullptr && node.bounds.centre() != glm::dvec3(0);
  held_ = Held{std::move(*there), *axis, at, *desk.selection(), off_origin};
  return true;
}

void ModelHand::move(ModelDesk& desk, const glm::dvec2& at) {
  if (!held_) {
    const auto there = handles(desk);
    over_ = there ? there->at(at, kReach * density_) : std::nullopt;
    return;
  }
  told_ = command(*held_, at);
  desk.drag(told_);
}

void ModelHand::release(ModelDesk& desk) {
  if (!held_) return;
  held_.reset();
  told_.clear();
  desk.end_drag();
}

// "": the mouse is where it was.
std::string ModelHand::command(const Held& held, const glm::dvec2& to) const {
  const auto three = [](const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  const char* about = held.off_origin ? " centre" : "";
  switch (held.handles.kind()) {
    case HandleKind::move: {
      const glm::dvec3 way = held.handles.moved(held.axis, held.from, to);
      return way == glm::dvec3(0) ? "" : change_of(held.what, "translate", three(way));
    }
    case HandleKind::turn: {
      const double degrees = held.handles.turned(held.axis, held.from, to);
      if (degrees == 0) return "";
      return change_of(held.what, "rotate",
                       fmt::format("{} {}{}", kAxes[held.axis], degrees, about));
    }
    case HandleKind::scale: {
      const glm::dvec3 factors = held.handles.scaled(held.axis, held.from, to);
      if (factors == glm::dvec3(1)) return "";
      const std::string text =
          held.axis == Handle::kAll ? fmt::format("{}", factors.x) : three(factors);
      return change_of(held.what, "scale", text + about);
    }
  }
  return "";
}

}  // namespace sir::viewer
