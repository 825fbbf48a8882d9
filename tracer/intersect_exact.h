// INTERSECTA (thesis 2.3.4) without rounding: the answer for exactly the numbers
// that the file and the ray hold. It stands behind the fast one and answers
// where that one cannot be sure.
#pragma once

#include "tracer/intersect.h"
#include "tracer/scene.h"

namespace sir {

/// Intersects the whole line with a primitive. Every decision (hit or miss,
/// tangent, parallel, which face) is the one of exact arithmetic; the ends are
/// the nearest T to the true ones but for a last rounding, an end that is 0 is 0,
/// and Span's errors are 0. Works in Cramer's form, local coordinates times the
/// determinant, so that no division precedes a decision: first in twice the
/// digits of double, and where these do not decide either (an exact tangent) in
/// Wide. Ends need not be better than `resolution` in t: 0 for what was said,
/// more for a ray whose start is known no better. The placement must not be
/// singular; a ray that is not finite, or has no direction, misses.
template <typename T>
bool intersect_exactly(PrimitiveKind kind, const Placement& placement, const RayCena<T>& ray,
                       T resolution, Span<T>& span);

}  // namespace sir
