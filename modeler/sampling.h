// What rays tell of a solid's inside: how large it is, and whether there is any of it (the thesis
// only compares bounds before it combines, 3.2.2.3).
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

#include "modeler/node.h"

namespace sir::modeler {

/// Found by rays along the three axes through the solid's bounds, from points spread evenly; the
/// same every time.
struct Sampling {
  double volume = 0;
  double error = 0;  ///< twice the standard error of the volume, from what groups of rays say
  std::size_t rays = 0;
  std::optional<glm::dvec3> inside;  ///< a point of the solid; none: no ray met it
  Box met;                           ///< around all points where a ray entered or left
};

/// `rays`: about how many. Here and below, once a stop is asked for, what is found so far comes
/// back and is worth nothing.
Sampling sample(const Node& tree, std::size_t rays, std::stop_token stop = {});

/// Where the solid is to be looked for: its bounds in SC_CENA, but without what differences and
/// intersections leave of them empty, as far as rays can tell; a little more rather than less.
Box filled_box(const Node& tree, std::stop_token stop = {});

/// Whether no ray meets anything of a composite, though there is something to its left part and, of
/// an intersection, to its right one. False where that is more work than an answer while one waits.
bool leaves_nothing(const Node& composite);

/// The composites of which no ray meets anything, though there is something to each part that
/// counts: differences that leave nothing, intersections of solids that share nothing. A part for
/// which the work would be out of proportion is taken to hold something.
std::vector<const Node*> empty_composites(const Node& tree, std::stop_token stop = {});

}  // namespace sir::modeler
