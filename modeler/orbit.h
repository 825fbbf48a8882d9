// A camera that is led by the mouse around a solid. The thesis's camera (3.6.2) is a file that is
// edited by hand; what comes out here is such a file.
#pragma once

#include "modeler/node.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// Amounts are parts of the picture: 1 is its whole width, or height. Until something moves it, the
/// camera is the one that was given, to the bit.
class Orbit {
 public:
  /// Starts from a .CAM; its up vector is the axis of turning.
  explicit Orbit(const CameraFile& camera);

  /// Starts where the whole box is seen (see framing()). An empty or endless box counts as the one
  /// from -1 to 1.
  Orbit(const Box& bounds, double aspect);

  /// Goes around the target as if the solid were turned by hand: by half a turn for a whole height
  /// to the right, or down. It stops short of looking along the axis.
  void turn(double right, double down);

  /// Moves the target in its plane, so that it follows the mouse.
  void pan(double right, double down);

  /// Makes the window smaller by a tenth for each step, as a lens does: the screen, behind which
  /// all that is seen must lie, stays where it is.
  void zoom(double steps);

  const CameraFile& camera() const { return camera_; }

 private:
  CameraFile camera_;
};

}  // namespace sir::modeler
