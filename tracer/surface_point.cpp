#include "tracer/surface_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sir {
namespace {

// Faces of cone and cylinder (see face_count()).
constexpr int kConeSide = 0;
constexpr int kCylinderTop = 1, kCylinderSide = 2;

template <typename T>
T unit(T x) {
  return std::clamp(x, T(0), T(1));
}

template <typename T>
T turn(T x, T z) {
  const T u = std::atan2(z, x) / (2 * std::numbers::pi_v<T>);
  const T wrapped = u < 0 ? u + 1 : u;
  return wrapped < 1 ? wrapped : T(0);  // -1e-20 + 1 rounds to 1
}

}  // namespace

template <typename T>
NormalLocal<T> outward_normal(PrimitiveKind kind, int face, PointLocal<T> p) {
  NormalLocal<T> n;
  switch (kind) {
    case PrimitiveKind::cube: n.v[face / 2] = face % 2 == 0 ? T(-1) : T(1); break;
    case PrimitiveKind::sphere: n.v = p.v; break;
    case PrimitiveKind::cone:
      if (face == kConeSide) {
        // Gradient of x^2 + z^2 - (y-1)^2; on the side 1-y is the radius.
        const T radius = std::hypot(p.v.x, p.v.z);
        n.v = radius > 0 ? glm::vec<3, T>(p.v.x, radius, p.v.z) : glm::vec<3, T>(0, 1, 0);
      } else {
        n.v.y = T(-1);
      }
      break;
    case PrimitiveKind::cylinder:
      if (face == kCylinderSide) n.v = {p.v.x, T(0), p.v.z};
      else n.v.y = face == kCylinderTop ? T(1) : T(-1);
      break;
  }
  return n;
}

template <typename T>
TextureUv<T> texture_uv(PrimitiveKind kind, int face, PointLocal<T> p) {
  const T x = p.v.x, y = p.v.y, z = p.v.z;
  switch (kind) {
    case PrimitiveKind::cube:
      if (face < 2) return {unit(z), unit(y)};
      if (face < 4) return {unit(x), unit(z)};
      return {unit(x), unit(y)};
    case PrimitiveKind::sphere:
      return {turn(x, z), unit(std::acos(std::clamp(-y, T(-1), T(1))) / std::numbers::pi_v<T>)};
    case PrimitiveKind::cone:
      if (face == kConeSide) return {turn(x, z), unit(y)};
      break;
    case PrimitiveKind::cylinder:
      if (face == kCylinderSide) return {turn(x, z), unit(y)};
      break;
  }
  return {unit((x + 1) / 2), unit((z + 1) / 2)};
}

template <typename T>
bool on_face(PrimitiveKind kind, int face, PointLocal<T> p, T tolerance) {
  const T x = p.v.x, y = p.v.y, z = p.v.z;
  const auto near = [&](T a, T b) { return std::abs(a - b) <= tolerance; };
  const auto within = [&](T a) { return a >= -tolerance && a <= 1 + tolerance; };
  switch (kind) {
    case PrimitiveKind::cube: {
      const int axis = face / 2;
      return near(p.v[axis], T(face % 2)) && within(p.v[(axis + 1) % 3]) &&
             within(p.v[(axis + 2) % 3]);
    }
    case PrimitiveKind::sphere: return near(std::sqrt(x * x + y * y + z * z), T(1));
    case PrimitiveKind::cone: {
      const T radius = std::sqrt(x * x + z * z);
      return face == kConeSide ? near(radius, T(1) - y) && within(y)
                               : near(y, T(0)) && within(radius);
    }
    case PrimitiveKind::cylinder: {
      const T radius = std::sqrt(x * x + z * z);
      // Face 0 is the cap Y=0, face 1 the cap Y=1.
      return face == kCylinderSide ? near(radius, T(1)) && within(y)
                                   : near(y, T(face)) && within(radius);
    }
  }
  return false;
}

#define SIR_INSTANTIATE(T)                                                   \
  template NormalLocal<T> outward_normal(PrimitiveKind, int, PointLocal<T>); \
  template TextureUv<T> texture_uv(PrimitiveKind, int, PointLocal<T>);       \
  template bool on_face(PrimitiveKind, int, PointLocal<T>, T);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
