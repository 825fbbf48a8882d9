#include "tracer/interval.h"

namespace sir {

template <typename T>
bool intersect_cube(const RayLocal<T>& ray, T unit, Span<T>& span) {
  const auto& o = ray.origin.v;
  const auto& d = ray.direction.v;
  Interval<T> inside;
  return inside.slab(o.x, d.x, T(0), unit, 0, 1) && inside.slab(o.y, d.y, T(0), unit, 2, 3) &&
         inside.slab(o.z, d.z, T(0), unit, 4, 5) && inside.to_span(span);
}

template bool intersect_cube(const RayLocal<float>&, float, Span<float>&);
template bool intersect_cube(const RayLocal<double>&, double, Span<double>&);

}  // namespace sir
