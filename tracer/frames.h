// Coordinate frames as types (thesis 2.3.3).
//
// SC_LOCAL  a primitive's own frame, where it has its standard size and place
// SC_CENA   the scene's frame: solids, lights and the camera are placed in it
// SC_OBS    the observer's frame: screen in the plane Z = 0, scene at Z > 0
//
// Points, vectors and normals of different frames do not mix, and neither do
// scalar types: both are compile errors. T is float, double or long double and
// runs unmixed from the primary ray to the colour.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace sir {

struct ScLocal;
struct ScCena;
struct ScObs;

template <typename Frame, typename T>
struct Vector {
  glm::vec<3, T> v{0};
  Vector operator+(Vector other) const { return {v + other.v}; }
  Vector operator-(Vector other) const { return {v - other.v}; }
  Vector operator-() const { return {-v}; }
  Vector operator*(T factor) const { return {v * factor}; }
};

template <typename Frame, typename T>
struct Point {
  glm::vec<3, T> v{0};
  Point operator+(Vector<Frame, T> step) const { return {v + step.v}; }
  Vector<Frame, T> operator-(Point other) const { return {v - other.v}; }
};

/// A surface normal. It is covariant: see Transform::apply(Normal).
template <typename Frame, typename T>
struct Normal {
  glm::vec<3, T> v{0};
  Normal operator-() const { return {-v}; }
};

template <typename Frame, typename T>
T dot(Vector<Frame, T> a, Vector<Frame, T> b) {
  return glm::dot(a.v, b.v);
}
template <typename Frame, typename T>
T dot(Normal<Frame, T> a, Vector<Frame, T> b) {
  return glm::dot(a.v, b.v);
}
/// 2^-e where squares of v's components overflow or lose digits by being small, e
/// the exponent of the largest. Kept apart, since it is hardly ever asked for.
template <typename T>
[[gnu::noinline, gnu::cold]] T out_of_harm(const glm::vec<3, T>& v) {
  const T size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0) || !std::isfinite(size)) return 1;
  return std::ldexp(T(1), std::clamp(-std::ilogb(size), std::numeric_limits<T>::min_exponent,
                                     std::numeric_limits<T>::max_exponent - 2));
}
/// Whether the square of a length is far from underflow and overflow.
template <typename T>
bool well_sized(T square) {
  constexpr T kLeast = std::numeric_limits<T>::min() /
                       (std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());
  return square >= kLeast && square <= std::numeric_limits<T>::max();
}
template <typename Frame, typename T>
T length(Vector<Frame, T> a) {
  const T square = glm::dot(a.v, a.v);
  if (well_sized(square)) [[likely]]
    return std::sqrt(square);
  const T factor = out_of_harm(a.v);
  return glm::length(a.v * factor) / factor;
}
/// a / |a|; no numbers where a is zero.
template <typename Frame, typename T>
Vector<Frame, T> normalize(Vector<Frame, T> a) {
  const T square = glm::dot(a.v, a.v);
  if (well_sized(square)) [[likely]]
    return {a.v * glm::inversesqrt(square)};
  return {glm::normalize(a.v * out_of_harm(a.v))};
}

/// P(t) = origin + t direction (thesis 2.3.2); the direction has any length
/// but zero, and t is measured in units of it.
template <typename Frame, typename T>
struct Ray {
  Point<Frame, T> origin;
  Vector<Frame, T> direction;
  Point<Frame, T> at(T t) const { return origin + direction * t; }
};

/// An affine map between two frames together with its inverse.
///
/// The files hold 4x4 matrices for row vectors, p' = p M with the translation
/// in the fourth line; line i of the file is column i here, so that
/// `linear * p + translation` is the thesis's p M. This is the only place that
/// knows of it.
///
/// The inverse is kept as row i of `numerators` over `divisors[i]`: a solid of
/// size 49 then divides by 49, which is exact where it should be, while a
/// factor 1/49 would move its faces by a rounding (see Inverse, numeric.h).
template <typename From, typename To, typename T>
struct Transform {
  glm::mat<3, 3, T> linear{T(1)};
  glm::mat<3, 3, T> numerators{T(1)};
  glm::vec<3, T> divisors{1};
  glm::vec<3, T> translation{0};

  Point<To, T> apply(Point<From, T> p) const { return {linear * p.v + translation}; }
  Vector<To, T> apply(Vector<From, T> d) const { return {linear * d.v}; }

  /// Normals go by the inverse's transpose, or a shear would tilt them off
  /// the surface. The result is not of unit length.
  Normal<To, T> apply(Normal<From, T> n) const { return {(n.v / divisors) * numerators}; }

  /// The way back subtracts the translation before the inverse is applied: a
  /// combined 4x4 inverse cancels badly far from the origin.
  Point<From, T> unapply(Point<To, T> p) const {
    return {(numerators * (p.v - translation)) / divisors};
  }
  Vector<From, T> unapply(Vector<To, T> d) const { return {(numerators * d.v) / divisors}; }

  /// unapply() without the division, for a map whose divisors are all the same:
  /// SC_LOCAL in units of 1/divisor. What was exact in the file's numbers stays
  /// exact here more often.
  Ray<From, T> unapply_times_divisor(const Ray<To, T>& ray) const {
    return {{numerators * (ray.origin.v - translation)}, {numerators * ray.direction.v}};
  }

  /// A ray keeps its parameter t through the map (thesis 2.3.3).
  Ray<From, T> unapply(const Ray<To, T>& ray) const {
    return {unapply(ray.origin), unapply(ray.direction)};
  }
};

template <typename T>
using PointLocal = Point<ScLocal, T>;
template <typename T>
using VectorLocal = Vector<ScLocal, T>;
template <typename T>
using NormalLocal = Normal<ScLocal, T>;
template <typename T>
using RayLocal = Ray<ScLocal, T>;
template <typename T>
using PointCena = Point<ScCena, T>;
template <typename T>
using VectorCena = Vector<ScCena, T>;
template <typename T>
using NormalCena = Normal<ScCena, T>;
template <typename T>
using RayCena = Ray<ScCena, T>;
template <typename T>
using RayObs = Ray<ScObs, T>;
template <typename T>
using LocalCena = Transform<ScLocal, ScCena, T>;

}  // namespace sir
