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
#include "tracer/intersect_textbook.h"
#include "tracer/products.h"
#include "tracer/scene.h"

namespace sir {

/// A primitive of the tree.
template <typename T>
struct Leaf {
  LocalCena<T> placement;
  T unit = 0;        ///< the common divisor of `placement`; 0: it has none
  T unit_error = 0;  ///< how far the true one may lie from it
  /// Relative errors that the way to SC_LOCAL leaves in each coordinate of an
  /// origin and of a direction, by the roundings that its row needs.
  glm::vec<3, T> origin_weight{0}, direction_weight{0};
  glm::vec<3, T> translation_slack{0};      ///< what rounding to T took from the translation,
                                            ///< in units of roundoff
  T stretch = 1;                            ///< largest row sum of |CENA_LOCAL|: how far a step
                                            ///< of 1 in SC_CENA may reach in SC_LOCAL
  std::array<std::uint32_t, 6> surfaces{};  ///< index into Scene::surfaces, by face
  T pace = 1;               ///< a power of two: about the size of the primitive's smallest
                            ///< extent, so that directions stay near 1 in SC_LOCAL
  bool tame = false;        ///< no number of the way to SC_LOCAL is lost to underflow; else rays
                            ///< are intersected exactly only
  std::uint32_t shape = 0;  ///< the same for primitives of one kind and place
  std::int64_t node = 0;    ///< the node's number in the file
  std::int32_t gate = -1;   ///< the gate that it feeds; -1: it is the whole solid
  PrimitiveKind kind = PrimitiveKind::cube;
  bool complemented = false;  ///< feeds "outside" instead of "inside"

  /// The ray in SC_LOCAL, its direction times `factor`, a power of two, with
  /// bounds of the errors.
  LocalRay<T> to_local(const RayCena<T>& ray, T factor) const;
};

template <typename T>
inline LocalRay<T> Leaf<T>::to_local(const RayCena<T>& ray, T factor) const {
  const VectorCena<T> direction = ray.direction * factor;
  const RayLocal<T> times_divisor = placement.unapply_times_divisor({ray.origin, direction});
  LocalRay<T> local{times_divisor.origin, times_divisor.direction, unit, {}, {}, unit_error};
  if (!(unit > 0)) {
    local.unit = 1;
    local.origin.v /= placement.divisors;
    local.direction.v /= placement.divisors;
  }
  glm::mat<3, 3, T> sizes = placement.numerators;
  for (int column = 0; column < 3; ++column) sizes[column] = magnitudes(sizes[column]);
  const auto way = magnitudes(ray.origin.v - placement.translation) + translation_slack;
  local.origin_error = origin_weight * (sizes * way);
  local.direction_error = direction_weight * (sizes * magnitudes(direction.v));
  return local;
}

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
  /// Times a start's error: as near comes the start to every primitive whose face it is
  /// taken to lie on, along each axis. The largest of the primitives' condition numbers,
  /// and room for what a tolerance in SC_LOCAL reaches at an edge.
  T spread = 4;
  std::vector<Leaf<T>> leaves;
  std::vector<Gate> gates;
  std::vector<PolishStep> polish;
  Hierarchy<T> hierarchy;                 ///< over the leaves' envelopes
  Products<T> products;                   ///< none for the textbook's formulas
  std::vector<Placement> placements;      ///< of each leaf, where T cannot hold the file's numbers
  std::vector<TextbookLeaf<T>> textbook;  ///< of each leaf, for rays to be traced by the textbook's
                                          ///< formulas; else none

  /// Where a leaf's primitive is put, as in the file.
  Placement placement(std::size_t leaf) const {
    if (!placements.empty()) return placements[leaf];
    const auto& held = leaves[leaf].placement;
    return {glm::dmat3(held.linear), glm::dvec3(held.translation)};
  }
};

/// Builds the solid of a scene that has been read (surfaces known, matrices
/// not singular). Never recurses.
template <typename T>
Solid<T> build_solid(const Scene& scene, Formulas formulas = Formulas::robust);

/// How far a point is at least from every primitive that adds to the solid: the
/// largest of the three distances along the axes of SC_CENA to its envelope; 0
/// within one.
template <typename T>
T clearance(const Solid<T>& solid, PointCena<T> point);

}  // namespace sir
