#include "tracer/interval.h"

namespace sir {

template <typename T>
Crossing intersect_sphere(const LocalRay<T>& ray, Span<T>& span) {
  constexpr T u = kUnitRoundoff<T>;
  const auto& o = ray.origin.v;
  const auto& d = ray.direction.v;
  const T o_sum = sum_of(o), o_error = sum_of(ray.origin_error);
  const T d_sum = sum_of(d), d_error = sum_of(ray.direction_error);
  if (!moderate(o_sum, o_error, d_sum, d_error)) return Crossing::unsure;

  // b^2 - a c = a r^2 - |o x d|^2 (Lagrange's identity). With x >= |d| r and m
  // the error of o x d, the square of o x d is off by 4 x m + 16 m^2 and the
  // roundings, where |o x d| is below 2 x; where it is above, the difference is
  // larger than what the square is off by.
  Quadratic<T> side;
  side.a = glm::dot(d, d);
  const auto moment = glm::cross(o, d);
  side.discriminant = side.a * (ray.unit * ray.unit) - glm::dot(moment, moment);
  const T x = ray.unit * d_sum;
  const T m = T(1.05) * (o_sum * d_error + d_sum * o_error) + 3 * u * o_sum * d_sum;
  side.discriminant_error = m * (4 * x + 16 * m) +
                            T(2.1) * x * (ray.unit * d_error + d_sum * ray.unit_error) +
                            30 * u * x * x;
  if (!(side.discriminant > side.discriminant_error))
    return side.discriminant < -side.discriminant_error ? Crossing::misses : Crossing::unsure;

  const T square = glm::dot(o, o), unit_square = ray.unit * ray.unit;
  side.b = glm::dot(o, d);
  side.c = square - unit_square;
  side.a_error = T(2.1) * d_sum * d_error + 4 * u * side.a;
  side.b_error = m;
  side.c_error = T(2.1) * (o_sum * o_error + ray.unit * ray.unit_error) + o_error * o_error +
                 5 * u * (square + unit_square);
  Located<T> enter, leave;
  if (!side.roots(enter, leave)) return Crossing::unsure;
  if (!(leave.t - enter.t > enter.error + leave.error)) return Crossing::unsure;
  span = {enter.t, leave.t, enter.error, leave.error, 0, 0};
  return Crossing::crosses;
}

template Crossing intersect_sphere(const LocalRay<float>&, Span<float>&);
template Crossing intersect_sphere(const LocalRay<double>&, Span<double>&);
template Crossing intersect_sphere(const LocalRay<long double>&, Span<long double>&);

}  // namespace sir
