// What is looked at besides the solids, and how: camera, light and surfaces (thesis 3.3, 3.6.2,
// 3.6.3), what is shown of a solid and which part of it is meant. In the thesis all this is in
// files that are edited by hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tracer/scene.h"

namespace sir::modeler {

/// As in BASE.CAM, .LUZ and .SUP. What is not there is made up (see Interpreter::camera(),
/// made_up_lighting(), made_up_surface()).
struct Looks {
  std::optional<CameraFile> camera;
  std::optional<Lighting> lighting;
  std::map<std::int64_t, Surface> surfaces;  ///< by number

  /// The surfaces as a file has them, by number.
  std::vector<Surface> surface_list() const;
};

/// All of the light for another; none: made up.
struct LightingChange {
  std::optional<Lighting> before, after;
};

/// Background or ambient light for another. Here and below the light is not made up.
struct ShadeChange {
  glm::dvec3 Lighting::*shade;
  glm::dvec3 before, after;
};

/// One light for another at its place in the list. None before: it is put in there; none after: it
/// is taken out.
struct LightChange {
  std::size_t index;
  std::optional<Light> before, after;
};

/// One surface for another of its number; none: not described.
struct SurfaceChange {
  std::int64_t number;
  std::optional<Surface> before, after;
};

/// What a command does to light or surfaces, so that it costs the same however many there are. It
/// can be done the other way round.
using LookChange = std::variant<LightingChange, ShadeChange, LightChange, SurfaceChange>;
using LookChanges = std::vector<LookChange>;
void apply(const LookChanges& changes, Looks& looks);
void revert(const LookChanges& changes, Looks& looks);

/// What is shown besides the solids (see preview.h, guides.h).
struct ViewSettings {
  bool ghosts = false, axes = true, bounds = true, grid = false, silhouette = false;
  bool alone = false;  ///< the selected solid alone; else all of the list
  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

/// A node of a solid, and perhaps one of its faces.
struct Selection {
  std::string solid;
  std::size_t place = 0;      ///< in preorder() of its tree; 0: the solid itself
  std::optional<int> face{};  ///< of a primitive, as in the .CSG
  friend bool operator==(const Selection&, const Selection&) = default;
};

}  // namespace sir::modeler
