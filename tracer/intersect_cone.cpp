#include "tracer/interval.h"

namespace sir {
namespace {

// A coordinate of the origin and of the direction, with bounds of their errors.
template <typename T>
struct Coordinate {
  T o, d, o_error, d_error;
};

// p dq - q dp, with a bound of its error.
template <typename T>
struct Minor {
  T value, error;
  Minor(const Coordinate<T>& p, const Coordinate<T>& q) : value(p.o * q.d - q.o * p.d) {
    const T one = std::abs(p.o * q.d), other = std::abs(q.o * p.d);
    error = (std::abs(p.o) + p.o_error) * q.d_error + std::abs(q.d) * p.o_error +
            (std::abs(q.o) + q.o_error) * p.d_error + std::abs(p.d) * q.o_error +
            3 * kUnitRoundoff<T> * (one + other);
  }
  T square_error() const { return error * (2 * std::abs(value) + error); }
};

}  // namespace

template <typename T>
Crossing intersect_cone(const LocalRay<T>& ray, Span<T>& span) {
  constexpr std::uint8_t kSide = 0, kBase = 1;
  constexpr T u = kUnitRoundoff<T>;
  // w = y - unit puts the apex in the origin: x^2 + z^2 < w^2, w in (-unit, 0).
  const auto& o = ray.origin.v;
  const auto& d = ray.direction.v;
  const T depth = o.y - ray.unit;
  const Coordinate<T> x{o.x, d.x, ray.origin_error.x, ray.direction_error.x};
  const Coordinate<T> z{o.z, d.z, ray.origin_error.z, ray.direction_error.z};
  const Coordinate<T> w{depth, d.y, ray.origin_error.y + ray.unit_error + u * std::abs(depth),
                        ray.direction_error.y};
  const T o_sum = std::abs(x.o) + std::abs(w.o) + std::abs(z.o), d_sum = sum_of(d);
  const T o_error = x.o_error + w.o_error + z.o_error, d_error = sum_of(ray.direction_error);
  if (!moderate(o_sum, o_error, d_sum, d_error)) return Crossing::unsure;

  Quadratic<T> side;
  side.a = d.x * d.x + d.z * d.z - d.y * d.y;
  side.a_error = T(2.1) * d_sum * d_error + 4 * u * glm::dot(d, d);
  if (!(std::abs(side.a) > 4 * side.a_error)) return Crossing::unsure;  // along a generator
  // b^2 - a c as minors, which do not cancel away from tangency.
  const Minor<T> xw(x, w), zw(z, w), xz(x, z);
  const T positive = xw.value * xw.value + zw.value * zw.value, negative = xz.value * xz.value;
  side.discriminant = positive - negative;
  side.discriminant_error =
      xw.square_error() + zw.square_error() + xz.square_error() + 4 * u * (positive + negative);
  if (!(side.discriminant > side.discriminant_error)) {
    // Only a ray flatter than the generators can miss both nappes.
    const bool misses = side.a > 0 && side.discriminant < -side.discriminant_error;
    return misses ? Crossing::misses : Crossing::unsure;
  }
  if (side.a > 0) {
    // Between the roots in one nappe: the lower where this, -w half-way between
    // them times a, is positive.
    const T half_way = d.x * xw.value + d.z * zw.value;
    const T error = std::abs(d.x) * xw.error + std::abs(d.z) * zw.error +
                    (x.d_error + 3 * u * std::abs(d.x)) * (std::abs(xw.value) + xw.error) +
                    (z.d_error + 3 * u * std::abs(d.z)) * (std::abs(zw.value) + zw.error);
    if (!(half_way > 2 * error)) return half_way < -2 * error ? Crossing::misses : Crossing::unsure;
  }

  Interval<T> inside;
  if (d.y == 0 && w.d_error == 0) {
    const Crossing between = Interval<T>::inside_slab(std::min(o.y, -w.o), w.o_error);
    if (between != Crossing::crosses) return between;
  } else {
    if (!(std::abs(d.y) > Interval<T>::kSteep * w.d_error)) return Crossing::unsure;
    const auto base = Interval<T>::plane(-o.y, ray.origin_error.y, d.y, w.d_error);
    if (d.y > 0) inside.enter_at(base, kBase);
    else inside.leave_at(base, kBase);
  }
  side.b = x.o * d.x + z.o * d.z - w.o * d.y;
  side.c = x.o * x.o + z.o * z.o - w.o * w.o;
  side.b_error = T(1.05) * (o_sum * d_error + d_sum * o_error) + 3 * u * o_sum * d_sum;
  side.c_error = T(2.1) * o_sum * o_error + o_error * o_error + 4 * u * o_sum * o_sum;
  Located<T> low, high;
  if (!side.roots(low, high)) return Crossing::unsure;
  if (side.a > 0) {
    inside.enter_at(low, kSide);
    inside.leave_at(high, kSide);
  } else if (d.y < 0) {
    // Steeper: through both nappes, outside between the roots. The lower nappe
    // lies beyond the root on the side where w falls.
    inside.enter_at(high, kSide);
  } else {
    inside.leave_at(low, kSide);
  }
  return inside.to_span(span);
}

template Crossing intersect_cone(const LocalRay<float>&, Span<float>&);
template Crossing intersect_cone(const LocalRay<double>&, Span<double>&);
template Crossing intersect_cone(const LocalRay<long double>&, Span<long double>&);

}  // namespace sir
