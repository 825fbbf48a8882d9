#include "tracer/interval.h"

namespace sir {

template <typename T>
bool intersect_sphere(const RayLocal<T>& ray, T unit, Span<T>& span) {
  const auto& o = ray.origin.v;
  const auto& d = ray.direction.v;
  const T a = glm::dot(d, d);
  if (!(a > 0)) return false;
  // b^2 - a c = a r^2 - |o x d|^2 (Lagrange's identity).
  const auto moment = glm::cross(o, d);
  const T discriminant = a * (unit * unit) - glm::dot(moment, moment);
  if (!(discriminant > 0)) return false;
  const Roots<T> roots(a, glm::dot(o, d), glm::dot(o, o) - unit * unit, std::sqrt(discriminant));
  span = {roots.low, roots.high, 0, 0};
  return span.enter < span.leave;
}

template bool intersect_sphere(const RayLocal<float>&, float, Span<float>&);
template bool intersect_sphere(const RayLocal<double>&, double, Span<double>&);

}  // namespace sir
