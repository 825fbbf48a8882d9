#include <glm/vec2.hpp>

#include "tracer/interval.h"

namespace sir {

template <typename T>
bool intersect_cylinder(const RayLocal<T>& ray, T unit, Span<T>& span) {
  constexpr std::uint8_t kBottom = 0, kTop = 1, kSide = 2;
  Interval<T> inside;
  if (!inside.slab(ray.origin.v.y, ray.direction.v.y, T(0), unit, kBottom, kTop)) return false;

  const glm::vec<2, T> o(ray.origin.v.x, ray.origin.v.z);
  const glm::vec<2, T> d(ray.direction.v.x, ray.direction.v.z);
  const T a = glm::dot(d, d);
  const T c = glm::dot(o, o) - unit * unit;
  if (a < std::numeric_limits<T>::min()) {
    // Parallel to the axis, or so nearly that the square underflows: within
    // the caps the ray then moves sideways by less than one rounding.
    return c < 0 && inside.to_span(span);
  }
  const T moment = o.x * d.y - o.y * d.x;
  const T discriminant = a * (unit * unit) - moment * moment;
  if (!(discriminant > 0)) return false;
  const Roots<T> roots(a, glm::dot(o, d), c, std::sqrt(discriminant));
  inside.enter_at(roots.low, kSide);
  inside.leave_at(roots.high, kSide);
  return inside.to_span(span);
}

template bool intersect_cylinder(const RayLocal<float>&, float, Span<float>&);
template bool intersect_cylinder(const RayLocal<double>&, double, Span<double>&);

}  // namespace sir
