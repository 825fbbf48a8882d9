#include "tracer/interval.h"

namespace sir {

template <typename T>
bool intersect_sphere(const RayLocal<T>& ray, Span<T>& span) {
  const auto& o = ray.origin.v;
  const auto& d = ray.direction.v;
  const T a = glm::dot(d, d);
  if (!(a > 0)) return false;
  const T b = glm::dot(o, d);
  const auto nearest = o - (b / a) * d;  // the line's point nearest to the centre
  const T margin = T(1) - glm::dot(nearest, nearest);
  if (!(margin > 0)) return false;
  const Roots<T> roots(a, b, glm::dot(o, o) - T(1), std::sqrt(a * margin));
  span = {roots.low, roots.high, 0, 0};
  return span.enter < span.leave;
}

template bool intersect_sphere(const RayLocal<float>&, Span<float>&);
template bool intersect_sphere(const RayLocal<double>&, Span<double>&);

}  // namespace sir
