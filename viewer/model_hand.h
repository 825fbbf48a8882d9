// The hand in the picture of the modeler's window: it takes hold of a handle of what is selected,
// and what it does is a command (transforma sólido, thesis 3.2.2.2).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "viewer/handles.h"
#include "viewer/model_desk.h"

namespace sir::viewer {

/// A command that changes a node: of a whole solid "VERB SOLID ARGUMENTS", of a part
/// "edit SOLID PLACE VERB ARGUMENTS".
std::string change_of(const modeler::Selection& what, std::string_view verb,
                      std::string_view arguments);

/// Places are pixels from the picture's top left corner.
class ModelHand {
 public:
  /// Which handles there are; none: they are hidden.
  std::optional<HandleKind> kind = HandleKind::move;

  /// Pixels to a unit of the window, for handles as large on every display.
  void set_density(double density) { density_ = density; }

  /// Those of what is selected now; none where nothing is, or it has no middle.
  std::optional<Handles> handles(const ModelDesk& desk) const;

  /// Takes hold of what is there; false where nothing is.
  bool press(const ModelDesk& desk, const glm::dvec2& at);
  /// While it holds something: does what it means. Else: looks what is there.
  void move(ModelDesk& desk, const glm::dvec2& at);
  void release(ModelDesk& desk);

  bool holds() const { return held_.has_value(); }
  /// The axis that is held, or else under the mouse.
  std::optional<int> axis() const { return held_ ? std::optional(held_->axis) : over_; }
  /// What it has done so far, as "rotate ball x 30"; "" where it holds nothing.
  const std::string& told() const { return told_; }

 private:
  struct Held {
    Handles handles;  // as they were: what is dragged goes along, its handles too
    int axis;
    glm::dvec2 from;
    modeler::Selection what;
    bool off_origin;  // a primitive that is not where transforms are about
  };
  std::string command(const Held& held, const glm::dvec2& to) const;

  double density_ = 1;
  std::optional<Held> held_;
  std::optional<int> over_;
  std::string told_;
};

}  // namespace sir::viewer
