// The CSG tree made ready for rays: primitives with both matrices, and the
// composition flattened, so that no ray ever walks a chain (thesis 2.3.5).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/bounds.h"
#include "tracer/frames.h"
#include "tracer/hierarchy.h"
#include "tracer/intersect.h"
#include "tracer/scene.h"

namespace sir {

/// A primitive of the tree.
template <typename T>
struct Leaf {
  LocalCena<T> placement;
  T unit = 0;                               ///< the common divisor of `placement`; 0: it has none
  T stretch = 1;                            ///< largest row sum of |CENA_LOCAL|: how far a step
                                            ///< of 1 in SC_CENA may reach in SC_LOCAL
  std::array<std::uint32_t, 6> surfaces{};  ///< index into Scene::surfaces, by face
  std::int64_t node = 0;                    ///< the node's number in the file
  std::int32_t gate = -1;                   ///< the gate that it feeds; -1: it is the whole solid
  PrimitiveKind kind = PrimitiveKind::cube;
  bool complemented = false;  ///< feeds "outside" instead of "inside"
};

/// One node of the flattened composition: inside when at least `needed` of its
/// inputs are. A chain of unions is a single gate that needs one input; a chain
/// of intersections and subtrahends one that needs all. De Morgan's laws move
/// every complement down to the leaves, so that gates are monotone.
struct Gate {
  std::int32_t parent = -1;
  std::int32_t needed = 0;
  std::int32_t at_rest = 0;  ///< true inputs where no primitive is
};

/// One step of the composition in reverse Polish order: a leaf, or an operation
/// on the two results before it. What the plain algorithm of Roth works on.
struct PolishStep {
  bool is_leaf = false;
  Operation operation = Operation::union_of;
  std::uint32_t leaf = 0;
};

/// The whole solid. Immutable while rays are traced.
template <typename T>
struct Solid {
  std::vector<Leaf<T>> leaves;
  std::vector<Gate> gates;
  std::vector<PolishStep> polish;
  Hierarchy<T> hierarchy;  ///< over the leaves' envelopes
  T roundings = 1;         ///< worst amplification |LOCAL_CENA| |CENA_LOCAL| of a rounding

  /// Distance in SC_CENA by which boxes must be widened for a ray from here.
  T box_margin(PointCena<T> origin) const {
    const T size = std::max({std::abs(origin.v.x), std::abs(origin.v.y), std::abs(origin.v.z)});
    return Numeric<T>::kBoxRoundings * Numeric<T>::kEpsilon * roundings * size;
  }
};

/// Builds the solid of a scene that has been read (surfaces known, matrices
/// not singular). Never recurses.
template <typename T>
Solid<T> build_solid(const Scene& scene);

}  // namespace sir
