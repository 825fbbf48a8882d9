// Handles in the picture: a solid is moved, turned or scaled (thesis 3.2.2.2) by what a hand takes
// hold of. Their geometry, without a window.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "modeler/screen_frame.h"
#include "tracer/camera.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::viewer {

enum class HandleKind : std::uint8_t { move, turn, scale };

/// One thing that can be taken hold of. Places are pixels from the picture's top left corner.
struct Handle {
  static constexpr int kAll = 3;  ///< no axis: the grip in the middle, for all at once

  int axis = kAll;               ///< 0: X, 1: Y, 2: Z of SC_CENA
  std::vector<glm::dvec2> line;  ///< from the middle to the grip; of a turn, the arc in front
};

/// The handles of one kind at a point of SC_CENA, as large on the screen whatever the camera is.
/// An axis that points at the observer has none. There are none at all where the point is not in
/// front of the eye.
class Handles {
 public:
  /// `length` of a line across the view, in pixels; at it is the grip, or the arc.
  Handles(HandleKind kind, const glm::dvec3& centre, const CameraFile& camera, ImageSize size,
          double length);

  HandleKind kind() const { return kind_; }
  const std::vector<Handle>& all() const& { return all_; }
  std::vector<Handle> all() && { return std::move(all_); }
  glm::dvec2 middle() const { return middle_; }

  /// The axis of the handle that is within reach, in pixels; the nearest.
  std::optional<int> at(const glm::dvec2& point, double reach) const;

  /// What a drag from one place to another means. Each is rounded to what a person would type: to a
  /// power of ten of SC_CENA that is no more than a pixel, to a degree, to a hundredth.
  ///
  /// Along the axis, so that it follows the mouse; or in the plane of the screen.
  glm::dvec3 moved(int axis, const glm::dvec2& from, const glm::dvec2& to) const;
  /// Degrees about the axis as rotation_about() counts them, in (-180, 180].
  double turned(int axis, const glm::dvec2& from, const glm::dvec2& to) const;
  /// Factors: of the axis, or all the same; at least 0.01.
  glm::dvec3 scaled(int axis, const glm::dvec2& from, const glm::dvec2& to) const;

 private:
  std::optional<glm::dvec2> seen(const glm::dvec3& point) const;
  double along(int axis, const glm::dvec2& from, const glm::dvec2& to) const;
  std::optional<double> on_axis(int axis, const glm::dvec2& at) const;
  std::optional<double> angle(int axis, const glm::dvec2& at) const;
  glm::dvec3 on_ring(int axis, double angle) const;
  void add_line(int axis);
  void add_arc(int axis);

  HandleKind kind_;
  glm::dvec3 centre_;
  CameraFile camera_;
  ImageSize size_;
  modeler::ScreenFrame frame_;
  Camera<double> rays_;
  double length_, unit_ = 0;  // the latter: of SC_CENA, a pixel's side at the centre
  glm::dvec2 middle_{0};
  std::vector<Handle> all_;
};

}  // namespace sir::viewer
