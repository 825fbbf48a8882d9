#include "tracer/interval.h"

namespace sir {

template <typename T>
Crossing intersect_cube(const LocalRay<T>& ray, Span<T>& span) {
  Interval<T> inside;
  Crossing answer = Crossing::crosses;
  for (int axis = 0; axis < 3; ++axis) {
    const auto face = static_cast<std::uint8_t>(2 * axis);
    const Crossing slab = inside.slab(ray, axis, face, face + 1);
    if (slab == Crossing::misses) return slab;
    if (slab == Crossing::unsure) answer = slab;
  }
  if (answer == Crossing::unsure) return answer;
  return inside.to_span(span);
}

template Crossing intersect_cube(const LocalRay<float>&, Span<float>&);
template Crossing intersect_cube(const LocalRay<double>&, Span<double>&);
template Crossing intersect_cube(const LocalRay<long double>&, Span<long double>&);

}  // namespace sir
