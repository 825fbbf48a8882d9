// INTERSECTA (thesis 2.3.4) as nearly every textbook has it: for measuring what
// the robust way costs and saves.
#pragma once

#include <glm/mat4x4.hpp>

#include "tracer/intersect.h"
#include "tracer/scene.h"

namespace sir {

/// How primitives are intersected, and how a ray leaves a surface.
enum class Formulas : std::uint8_t {
  robust,   ///< with bounds of the errors, and exactly where they leave a doubt; a secondary ray
            ///< carries the face that it stands on
  textbook  ///< this page's, right or wrong; a secondary ray has no hits nearer than
            ///< kTextbookStart
};

/// The textbook's epsilon: what keeps a secondary ray from meeting the surface
/// that it leaves. A distance in SC_CENA, the same for scenes of every size.
template <typename T>
inline constexpr T kTextbookStart = T(1e-4L);

/// A primitive ready to be intersected: CENA_LOCAL as one 4x4 inverse in T.
template <typename T>
struct TextbookLeaf {
  PrimitiveKind kind;
  glm::mat<4, 4, T> inverse;

  TextbookLeaf(PrimitiveKind primitive, const Placement& placement);
};

/// Intersects the whole line: b^2-4ac and (-b +- sqrt)/2a in SC_LOCAL, without a
/// bound of any error. The span's errors are 0, as if it were exact.
template <typename T>
bool intersect_as_in_textbooks(const TextbookLeaf<T>& leaf, const RayCena<T>& ray, Span<T>& span);

}  // namespace sir
