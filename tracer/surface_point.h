// Geometry on the faces of the primitives, in SC_LOCAL (BASICO's normals and
// calcula_uv, thesis 2.4.4 and 3.3.1).
#pragma once

#include "tracer/intersect.h"

namespace sir {

/// Texture coordinates, both within [0,1].
template <typename T>
struct TextureUv {
  T u, v;
};

/// Outward normal of a face at a point on it; not of unit length. At the cone's
/// apex, where there is none, the axis.
template <typename T>
NormalLocal<T> outward_normal(PrimitiveKind kind, int face, PointLocal<T> p);

/// Texture coordinates of a point on a face:
/// cube X=c (z,y), Y=c (x,z), Z=c (x,y); sphere u = atan2(z,x)/2pi wrapped to
/// [0,1), v = acos(-y)/pi; sides of cone and cylinder u likewise, v = y; caps
/// and base ((x+1)/2, (z+1)/2). Clamped, so that rounding never leaves [0,1].
template <typename T>
TextureUv<T> texture_uv(PrimitiveKind kind, int face, PointLocal<T> p);

/// Whether p lies on the face, within its limits, to within the distance
/// `tolerance` >= 0 in SC_LOCAL.
template <typename T>
bool on_face(PrimitiveKind kind, int face, PointLocal<T> p, T tolerance);

}  // namespace sir
