// INTERSECTA (thesis 2.3.4, 3.3): a ray in SC_LOCAL against a primitive.
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
  std::uint8_t enter_face, leave_face;
};

/// Intersects the whole line, t from minus to plus infinity. False: the line is
/// OUT, which includes touching in a point or an edge and lying in a face.
/// Where the line meets two faces at once (an edge), the lower face is named.
///
/// `unit` > 0 is the length of SC_LOCAL's unit in the ray's coordinates: 1, or
/// the divisor that Transform::unapply_times_divisor left undone.
///
/// Discriminants are taken as sums of minors such as x dz - z dx, never as
/// b^2-4ac (compare Haines et al., Ray Tracing Gems ch. 7), the second root as
/// c/q (Kahan): distant and nearly parallel rays keep their digits, and what
/// touches exactly, in numbers short enough, is found to touch.
template <typename T>
bool intersect_cube(const RayLocal<T>& ray, T unit, Span<T>& span);
template <typename T>
bool intersect_sphere(const RayLocal<T>& ray, T unit, Span<T>& span);
template <typename T>
bool intersect_cone(const RayLocal<T>& ray, T unit, Span<T>& span);
template <typename T>
bool intersect_cylinder(const RayLocal<T>& ray, T unit, Span<T>& span);

template <typename T>
inline bool intersect(PrimitiveKind kind, const RayLocal<T>& ray, T unit, Span<T>& span) {
  switch (kind) {
    case PrimitiveKind::cube: return intersect_cube(ray, unit, span);
    case PrimitiveKind::sphere: return intersect_sphere(ray, unit, span);
    case PrimitiveKind::cone: return intersect_cone(ray, unit, span);
    case PrimitiveKind::cylinder: return intersect_cylinder(ray, unit, span);
  }
  return false;
}

}  // namespace sir
