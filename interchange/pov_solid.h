// The composition as POV-Ray's CSG (thesis 2.3.1).
#pragma once

#include <string>

#include "interchange/pov_view.h"
#include "tracer/scene.h"

namespace sir {

struct PovSolid {
  std::string text;      ///< one CSG statement
  std::string interior;  ///< what is to be said of it as a whole; may be empty
};

/// The whole solid. Chains of unions become one statement with many members, and
/// so do chains of intersections and of subtractions. Never recurses. (What cannot be flattened,
/// unions of intersections of unions and so on, it takes 10,000 deep and more, in a time that grows
/// with the square of the depth.)
///
/// A union in which a surface is transparent becomes a `merge`, which has no
/// walls inside, as ours; an opaque one a `union`, whose walls inside cannot be
/// seen and which POV-Ray traces faster.
///
/// POV-Ray knows a medium by its `interior`, of which parts share one where it
/// is given to their CSG statement: members of a union that have the same index
/// of refraction are put together for that.
PovSolid pov_solid(const Scene& scene, const PovFrame& frame);

}  // namespace sir
