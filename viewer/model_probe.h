// What is under the mouse in the modeler's window: node, face and surface at a pixel (RAY-TRACING,
// thesis 2.3.6), of all solids in the list.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/interpreter.h"
#include "modeler/pick.h"

namespace sir::viewer {

struct Probed {
  modeler::Pick pick;       ///< as of what is shown; its node lives as long as the probe is not
                            ///< asked again
  modeler::Selection what;  ///< solid, place in its tree, face
};

/// "\"haste\" in \"calice\" at 3: cylinder, face side, surface 2   (0.1, 0.2, 0.3)   t 1.5"
std::string text_of(const Probed& probed);

/// Keeps what it made ready as long as solids, camera and size are the same, so that a mouse that
/// moves costs a ray. For one thread.
class ModelProbe {
 public:
  /// All solids of the list as one, or the selected one alone where the view says so; null: none.
  modeler::NodePtr shown(const modeler::Interpreter& interpreter);

  /// What the primary ray through a pixel of a picture of what is shown meets; none: the
  /// background.
  std::optional<Probed> at(const modeler::Interpreter& interpreter, ImageSize size, int column,
                           int row);

 private:
  std::vector<modeler::NodePtr> parts_;  // the trees that are shown
  modeler::NodePtr shown_;               // as one
  std::unique_ptr<modeler::Picker> picker_;
  CameraFile camera_;  // of the picker
  ImageSize size_{0, 0};
};

}  // namespace sir::viewer
