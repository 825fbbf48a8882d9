#include "tracer/interval.h"

namespace sir {

template <typename T>
Crossing intersect_cylinder(const LocalRay<T>& ray, Span<T>& span) {
  constexpr std::uint8_t kBottom = 0, kTop = 1, kSide = 2;
  constexpr T u = kUnitRoundoff<T>;
  const T x = ray.origin.v.x, z = ray.origin.v.z, dx = ray.direction.v.x, dz = ray.direction.v.z;
  const T o_sum = std::abs(x) + std::abs(z), d_sum = std::abs(dx) + std::abs(dz);
  const T o_error = ray.origin_error.x + ray.origin_error.z;
  const T d_error = ray.direction_error.x + ray.direction_error.z;
  const T square = x * x + z * z, unit_square = ray.unit * ray.unit;

  Interval<T> inside;
  const Crossing slab = inside.slab(ray, 1, kBottom, kTop);
  if (slab == Crossing::misses) return slab;

  Quadratic<T> side;
  side.c = square - unit_square;
  side.c_error = T(2.1) * (o_sum * o_error + ray.unit * ray.unit_error) + o_error * o_error +
                 5 * u * (square + unit_square);
  if (d_sum == 0 && d_error == 0) {  // parallel to the axis without a doubt
    const Crossing side_crossing = Interval<T>::inside_slab(-side.c, side.c_error);
    if (side_crossing != Crossing::crosses) return side_crossing;
    return slab == Crossing::crosses ? inside.to_span(span) : slab;
  }
  if (!moderate(o_sum, o_error, d_sum, d_error)) return Crossing::unsure;

  // As the sphere's, in the plane of the caps.
  side.a = dx * dx + dz * dz;
  const T moment = x * dz - z * dx;
  side.discriminant = side.a * unit_square - moment * moment;
  const T reach = ray.unit * d_sum;
  const T m = T(1.05) * (o_sum * d_error + d_sum * o_error) + 3 * u * o_sum * d_sum;
  side.discriminant_error = m * (4 * reach + 16 * m) +
                            T(2.1) * reach * (ray.unit * d_error + d_sum * ray.unit_error) +
                            30 * u * reach * reach;
  if (!(side.discriminant > side.discriminant_error))
    return side.discriminant < -side.discriminant_error ? Crossing::misses : Crossing::unsure;
  if (slab == Crossing::unsure) return slab;

  side.b = x * dx + z * dz;
  side.a_error = T(2.1) * d_sum * d_error + 4 * u * side.a;
  side.b_error = m;
  Located<T> enter, leave;
  if (!side.roots(enter, leave)) return Crossing::unsure;
  inside.enter_at(enter, kSide);
  inside.leave_at(leave, kSide);
  return inside.to_span(span);
}

template Crossing intersect_cylinder(const LocalRay<float>&, Span<float>&);
template Crossing intersect_cylinder(const LocalRay<double>&, Span<double>&);
template Crossing intersect_cylinder(const LocalRay<long double>&, Span<long double>&);

}  // namespace sir
