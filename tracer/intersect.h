// INTERSECTA (thesis 2.3.4, 3.3): a ray in SC_LOCAL against a primitive, fast,
// and knowing what it does not know.
#pragma once

#include <cstdint>

#include "tracer/frames.h"

namespace sir {

/// The primitives in their standard places (tables 2.1-2.3):
/// cube [0,1]^3; sphere of radius 1 at the origin; cone x^2+z^2=(y-1)^2 with
/// 0<=y<=1, apex (0,1,0); cylinder x^2+z^2=1 with 0<=y<=1.
enum class PrimitiveKind : std::uint8_t { cube, sphere, cone, cylinder };

/// Number of faces. Cube: X=0, X=1, Y=0, Y=1, Z=0, Z=1. Sphere: 0.
/// Cone: side, base. Cylinder: Y=0, Y=1, side.
constexpr int face_count(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::cube: return 6;
    case PrimitiveKind::sphere: return 1;
    case PrimitiveKind::cone: return 2;
    case PrimitiveKind::cylinder: return 3;
  }
  return 0;
}

/// The part of a line that lies inside a primitive: OUT_IN_OUT. The primitives
/// are convex, so there is at most one; enter < leave always.
template <typename T>
struct Span {
  T enter, leave;
  T enter_error = 0, leave_error = 0;  ///< the true ends lie within this of the given ones
  std::uint8_t enter_face, leave_face;
};

/// What can be said of a line and a primitive. `misses` is OUT, which includes
/// touching in a point or an edge and lying in a face. `unsure`: rounding could
/// decide, as near a tangent or an edge; intersect_exactly() knows.
enum class Crossing : std::uint8_t { misses, crosses, unsure };

/// A ray in SC_LOCAL with bounds of the errors that its way there has left in
/// it: each true coordinate lies within these of the given one.
template <typename T>
struct LocalRay {
  Point<ScLocal, T> origin;
  Vector<ScLocal, T> direction;
  T unit = 1;  ///< the length of SC_LOCAL's unit in these coordinates, > 0
  glm::vec<3, T> origin_error{0}, direction_error{0};
  T unit_error = 0;
};

/// Intersects the whole line, t from minus to plus infinity. Where the line
/// meets two faces within 32 ulp of t (an edge), the lower face is named.
///
/// What it answers is certain: errors are bounded from the ray's onwards. The
/// discriminants are taken as sums of minors such as x dz - z dx, never as
/// b^2-4ac (compare Haines et al., Ray Tracing Gems ch. 7), and the second root
/// as c/q (Kahan), so that few rays are left unsure: distant and nearly
/// parallel ones keep their digits.
template <typename T>
Crossing intersect_cube(const LocalRay<T>& ray, Span<T>& span);
template <typename T>
Crossing intersect_sphere(const LocalRay<T>& ray, Span<T>& span);
template <typename T>
Crossing intersect_cone(const LocalRay<T>& ray, Span<T>& span);
template <typename T>
Crossing intersect_cylinder(const LocalRay<T>& ray, Span<T>& span);

template <typename T>
inline Crossing intersect(PrimitiveKind kind, const LocalRay<T>& ray, Span<T>& span) {
  switch (kind) {
    case PrimitiveKind::cube: return intersect_cube(ray, span);
    case PrimitiveKind::sphere: return intersect_sphere(ray, span);
    case PrimitiveKind::cone: return intersect_cone(ray, span);
    case PrimitiveKind::cylinder: return intersect_cylinder(ray, span);
  }
  return Crossing::unsure;
}

}  // namespace sir
