// The four primitives for a chunk of a packet: see packet_span-inl.h.
#if defined(SIR_TRACER_PACKET_KINDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_KINDS_INL_H_
#undef SIR_TRACER_PACKET_KINDS_INL_H_
#else
#define SIR_TRACER_PACKET_KINDS_INL_H_
#endif

#include "tracer/packet_span-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

template <typename T>
HWY_INLINE void cross_cubes(const PacketLeaf<T>& leaf, const LocalRays<T>& ray, Truths<T> where,
                            Spans<T>& spans) {
  Intervals<T> inside;
  Truths<T> sure = where, possible = where;
  for (int axis = 0; axis < 3; ++axis) {
    const auto face = static_cast<std::uint32_t>(2 * axis);
    const auto slab = inside.slab(leaf, ray, axis, face, face + 1);
    sure &= slab.crosses;
    possible -= slab.misses;
  }
  spans.unsure = possible - sure;
  inside.to_spans(sure, spans);
}

// The bound of the discriminant's error of sphere and cylinder, and m.
template <typename T>
struct RoundBound {
  Numbers<T> m, discriminant_error;
  HWY_INLINE RoundBound(const PacketLeaf<T>& leaf, Numbers<T> o_sum, Numbers<T> o_error,
                        Numbers<T> d_sum, Numbers<T> d_error) {
    using V = Numbers<T>;
    constexpr T u = kUnitRoundoff<T>;
    const V unit(leaf.unit), unit_error(leaf.unit_error), x = unit * d_sum;
    m = V(T(1.05)) * (o_sum * d_error + d_sum * o_error) + V(3 * u) * o_sum * d_sum;
    discriminant_error = m * (V(T(4)) * x + V(T(16)) * m) +
                         V(T(2.1)) * x * (unit * d_error + d_sum * unit_error) + V(30 * u) * x * x;
  }
};

template <typename T>
HWY_INLINE void cross_spheres(const PacketLeaf<T>& leaf, const LocalRays<T>& ray, Truths<T> where,
                              Spans<T>& spans) {
  using V = Numbers<T>;
  constexpr T u = kUnitRoundoff<T>;
  const V* o = ray.o;
  const V* d = ray.d;
  const V o_sum = abs(o[0]) + abs(o[1]) + abs(o[2]);
  const V o_error = abs(ray.o_error[0]) + abs(ray.o_error[1]) + abs(ray.o_error[2]);
  const V d_sum = abs(d[0]) + abs(d[1]) + abs(d[2]);
  const V d_error = abs(ray.d_error[0]) + abs(ray.d_error[1]) + abs(ray.d_error[2]);
  const Truths<T> mild = where & moderate(o_sum, o_error, d_sum, d_error);

  Quadratics<T> side;
  side.a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const V moment_x = o[1] * d[2] - d[1] * o[2];
  const V moment_y = o[2] * d[0] - d[2] * o[0];
  const V moment_z = o[0] * d[1] - d[0] * o[1];
  const V unit(leaf.unit), unit_error(leaf.unit_error), unit_square = unit * unit;
  side.discriminant =
      side.a * unit_square - (moment_x * moment_x + moment_y * moment_y + moment_z * moment_z);
  const RoundBound<T> bound(leaf, o_sum, o_error, d_sum, d_error);
  side.discriminant_error = bound.discriminant_error;
  const Truths<T> meets_it = side.discriminant > side.discriminant_error;
  const Truths<T> misses = mild & (side.discriminant < -side.discriminant_error);
  spans.crosses = Truths<T>::none();
  spans.unsure = where - misses;
  if (!(mild & meets_it).any()) return;

  const V square = o[0] * o[0] + o[1] * o[1] + o[2] * o[2];
  side.b = o[0] * d[0] + o[1] * d[1] + o[2] * d[2];
  side.c = square - unit_square;
  side.a_error = V(T(2.1)) * d_sum * d_error + V(4 * u) * side.a;
  side.b_error = bound.m;
  side.c_error = V(T(2.1)) * (o_sum * o_error + unit * unit_error) + o_error * o_error +
                 V(5 * u) * (square + unit_square);
  Places<T> enter, leave;
  const Truths<T> known = side.roots(enter, leave);
  spans.crosses = mild & meets_it & known & (leave.t - enter.t > enter.error + leave.error);
  spans.unsure -= spans.crosses;
  spans.enter = enter.t;
  spans.leave = leave.t;
  spans.enter_error = enter.error;
  spans.leave_error = leave.error;
  spans.enter_face = spans.leave_face = Codes<T>(0u);
}

template <typename T>
HWY_INLINE void cross_cylinders(const PacketLeaf<T>& leaf, const LocalRays<T>& ray, Truths<T> where,
                                Spans<T>& spans) {
  using V = Numbers<T>;
  constexpr std::uint32_t kBottom = 0, kTop = 1, kSide = 2;
  constexpr T u = kUnitRoundoff<T>;
  const V x = ray.o[0], z = ray.o[2], dx = ray.d[0], dz = ray.d[2], zero(T(0));
  const V o_sum = abs(x) + abs(z), d_sum = abs(dx) + abs(dz);
  const V o_error = ray.o_error[0] + ray.o_error[2], d_error = ray.d_error[0] + ray.d_error[2];
  const V unit(leaf.unit), unit_error(leaf.unit_error);
  const V square = x * x + z * z, unit_square = unit * unit;

  Intervals<T> inside;
  const auto slab = inside.slab(leaf, ray, 1, kBottom, kTop);
  const Truths<T> possible = where - slab.misses;
  Quadratics<T> side;
  side.c = square - unit_square;
  side.c_error = V(T(2.1)) * (o_sum * o_error + unit * unit_error) + o_error * o_error +
                 V(5 * u) * (square + unit_square);
  const Truths<T> along = possible & (d_sum == zero) & (d_error == zero);
  Truths<T> sure = Truths<T>::none();
  spans.unsure = Truths<T>::none();
  if (HWY_UNLIKELY(along.any())) {
    const auto within = Intervals<T>::inside_slab(-side.c, side.c_error);
    sure = along & within.crosses & slab.crosses;
    spans.unsure = (along - within.misses) - sure;
  }
  const Truths<T> across = possible - along;
  const Truths<T> mild = across & moderate(o_sum, o_error, d_sum, d_error);
  spans.unsure |= across - mild;

  side.a = dx * dx + dz * dz;
  const V moment = x * dz - z * dx;
  side.discriminant = side.a * unit_square - moment * moment;
  const RoundBound<T> bound(leaf, o_sum, o_error, d_sum, d_error);
  side.discriminant_error = bound.discriminant_error;
  const Truths<T> meets_it = mild & (side.discriminant > side.discriminant_error);
  const Truths<T> misses = mild & (side.discriminant < -side.discriminant_error);
  spans.unsure |= (mild - misses) - meets_it;
  spans.unsure |= meets_it - slab.crosses;
  const Truths<T> through = meets_it & slab.crosses;
  if (through.any()) {
    side.b = x * dx + z * dz;
    side.a_error = V(T(2.1)) * d_sum * d_error + V(4 * u) * side.a;
    side.b_error = bound.m;
    Places<T> enter, leave;
    const Truths<T> known = side.roots(enter, leave);
    spans.unsure |= through - known;
    inside.enter_at(through & known, enter, Codes<T>(kSide));
    inside.leave_at(through & known, leave, Codes<T>(kSide));
    sure |= through & known;
  }
  inside.to_spans(sure, spans);
}

template <typename T>
struct Coordinates {
  Numbers<T> o, d, o_error, d_error;
};

template <typename T>
struct Minors {
  Numbers<T> value, error;
  HWY_INLINE Minors(const Coordinates<T>& p, const Coordinates<T>& q) {
    using V = Numbers<T>;
    value = p.o * q.d - q.o * p.d;
    const V one = abs(p.o * q.d), other = abs(q.o * p.d);
    error = (abs(p.o) + p.o_error) * q.d_error + abs(q.d) * p.o_error +
            (abs(q.o) + q.o_error) * p.d_error + abs(p.d) * q.o_error +
            V(3 * kUnitRoundoff<T>) * (one + other);
  }
  HWY_INLINE Numbers<T> square_error() const {
    return error * (Numbers<T>(T(2)) * abs(value) + error);
  }
};

template <typename T>
HWY_INLINE void cross_cones(const PacketLeaf<T>& leaf, const LocalRays<T>& ray, Truths<T> where,
                            Spans<T>& spans) {
  using V = Numbers<T>;
  constexpr std::uint32_t kSide = 0, kBase = 1;
  constexpr T u = kUnitRoundoff<T>;
  const V* o = ray.o;
  const V* d = ray.d;
  const V zero(T(0)), depth = o[1] - V(leaf.unit);
  const Coordinates<T> x{o[0], d[0], ray.o_error[0], ray.d_error[0]};
  const Coordinates<T> z{o[2], d[2], ray.o_error[2], ray.d_error[2]};
  const Coordinates<T> w{depth, d[1], ray.o_error[1] + V(leaf.unit_error) + V(u) * abs(depth),
                         ray.d_error[1]};
  const V o_sum = abs(x.o) + abs(w.o) + abs(z.o), d_sum = abs(d[0]) + abs(d[1]) + abs(d[2]);
  const V o_error = x.o_error + w.o_error + z.o_error;
  const V d_error = abs(ray.d_error[0]) + abs(ray.d_error[1]) + abs(ray.d_error[2]);
  Truths<T> on = where & moderate(o_sum, o_error, d_sum, d_error);

  Quadratics<T> side;
  side.a = d[0] * d[0] + d[2] * d[2] - d[1] * d[1];
  side.a_error = V(T(2.1)) * d_sum * d_error + V(4 * u) * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  on &= abs(side.a) > V(T(4)) * side.a_error;
  const Minors<T> xw(x, w), zw(z, w), xz(x, z);
  const V positive = xw.value * xw.value + zw.value * zw.value;
  const V negative = xz.value * xz.value;
  side.discriminant = positive - negative;
  side.discriminant_error =
      xw.square_error() + zw.square_error() + xz.square_error() + V(4 * u) * (positive + negative);
  const Truths<T> flat = side.a > zero;
  Truths<T> misses = on & flat & (side.discriminant < -side.discriminant_error);
  on &= side.discriminant > side.discriminant_error;
  {
    const V half_way = d[0] * xw.value + d[2] * zw.value;
    const V error = abs(d[0]) * xw.error + abs(d[2]) * zw.error +
                    (x.d_error + V(3 * u) * abs(d[0])) * (abs(xw.value) + xw.error) +
                    (z.d_error + V(3 * u) * abs(d[2])) * (abs(zw.value) + zw.error);
    const V twice = V(T(2)) * error;
    const Truths<T> lower = half_way > twice;
    misses |= ((on & flat) - lower) & (half_way < -twice);
    on &= lower | !flat;
  }
  spans.unsure = where - misses;
  spans.crosses = Truths<T>::none();
  if (!on.any()) return;

  Intervals<T> inside;
  const Truths<T> parallel = on & (d[1] == zero) & (w.d_error == zero);
  const Truths<T> steep = (on - parallel) & (abs(d[1]) > V(Intervals<T>::kSteep) * w.d_error);
  const Places<T> base = Intervals<T>::plane(-o[1], ray.o_error[1], d[1], w.d_error);
  const Truths<T> up = d[1] > zero;
  inside.enter_at(steep & up, base, Codes<T>(kBase));
  inside.leave_at(steep - up, base, Codes<T>(kBase));
  on = steep;
  if (HWY_UNLIKELY(parallel.any())) {
    const auto between = Intervals<T>::inside_slab(min_of(o[1], -w.o), w.o_error);
    on |= parallel & between.crosses;
    spans.unsure -= parallel & between.misses;
  }
  side.b = x.o * d[0] + z.o * d[2] - w.o * d[1];
  side.c = x.o * x.o + z.o * z.o - w.o * w.o;
  side.b_error = V(T(1.05)) * (o_sum * d_error + d_sum * o_error) + V(3 * u) * o_sum * d_sum;
  side.c_error = V(T(2.1)) * o_sum * o_error + o_error * o_error + V(4 * u) * o_sum * o_sum;
  Places<T> low, high;
  on &= side.roots(low, high);
  const Truths<T> down = d[1] < zero;
  const Codes<T> side_code(kSide);
  inside.enter_at(on & flat, low, side_code);
  inside.leave_at(on & flat, high, side_code);
  inside.enter_at((on - flat) & down, high, side_code);
  inside.leave_at((on - flat) - down, low, side_code);
  spans.unsure -= on;
  inside.to_spans(on, spans);
}

/// Whether a point may lie on one of the faces to within `tolerance`, in units of
/// SC_LOCAL, as on_face() of any face would say; never false where it would not.
template <typename T>
HWY_INLINE Truths<T> near_surface(const PacketLeaf<T>& leaf, const Numbers<T>* o,
                                  Numbers<T> tolerance) {
  using V = Numbers<T>;
  constexpr T kSlack = 16 * Numeric<T>::kEpsilon;
  const V unit(leaf.unit), zero(T(0));
  const V near =
      tolerance * V(leaf.unit * T(1.001)) + V(kSlack) * (abs(o[0]) + abs(o[1]) + abs(o[2]) + unit);
  // Whether two lengths differ by no more, told by their squares.
  const auto squares_near = [&](V square, V length) HWY_ATTR {
    const V other = length * length;
    return abs(square - other) <=
           V(T(1.01)) * near * (V(T(2)) * abs(length) + near) + V(kSlack) * (square + other);
  };
  const auto outside = [&](int axis) HWY_ATTR { return greater(-o[axis], o[axis] - unit); };
  const V across = o[0] * o[0] + o[2] * o[2];
  const V wide = (unit + near) * V(T(1.01));
  switch (leaf.kind) {
    case PrimitiveKind::cube: {
      const V most = greater(greater(outside(0), outside(1)), outside(2));
      return abs(most) <= near;
    }
    case PrimitiveKind::sphere: return squares_near(across + o[1] * o[1], unit);
    case PrimitiveKind::cone: {
      const Truths<T> side = squares_near(across, unit - o[1]) & (outside(1) <= near);
      return side | ((abs(o[1]) <= near) & (across <= wide * wide));
    }
    case PrimitiveKind::cylinder: {
      const Truths<T> side = squares_near(across, unit) & (outside(1) <= near);
      return side | ((abs(outside(1)) <= near) & (across <= wide * wide));
    }
  }
  return abs(zero) <= zero;
}

/// The primitive and the rays of `where`, tame ones: Classifier::gather() up to what
/// a start makes of it.
template <typename T>
HWY_NOINLINE void cross(const PacketLeaf<T>& leaf, const ReadyPacket<T>& rays, std::size_t lane,
                        Truths<T> where, Spans<T>& spans) {
  using V = Numbers<T>;
  const V pace = V::load(rays.pace + lane) * V(leaf.pace);
  const auto normal = [](T one) { return std::isnormal(one); };
  const Truths<T> asked = where;
  // Paces are powers of two: those between are normal too.
  if (HWY_UNLIKELY(!leaf.tame || !normal(rays.least_pace * leaf.pace) ||
                   !normal(rays.most_pace * leaf.pace)))
    where &= leaf.tame ? (pace >= V(std::numeric_limits<T>::min())) &
                             (pace <= V(std::numeric_limits<T>::max()))
                       : Truths<T>::none();
  const V zero(T(0));
  spans.enter = spans.leave = spans.enter_error = spans.leave_error = zero;
  spans.enter_face = spans.leave_face = Codes<T>(0u);
  LocalRays<T> local;
  if (leaf.diagonal) to_local<T, true>(leaf, rays, lane, local);
  else to_local<T, false>(leaf, rays, lane, local);
  switch (leaf.kind) {
    case PrimitiveKind::cube: cross_cubes(leaf, local, where, spans); break;
    case PrimitiveKind::sphere: cross_spheres(leaf, local, where, spans); break;
    case PrimitiveKind::cone: cross_cones(leaf, local, where, spans); break;
    case PrimitiveKind::cylinder: cross_cylinders(leaf, local, where, spans); break;
  }
  spans.unsure |= asked - where;
  spans.near_start = Truths<T>::none();
  if (!spans.crosses.any()) return;
  spans.enter = spans.enter * pace;
  spans.leave = spans.leave * pace;
  spans.enter_error = spans.enter_error * pace;
  spans.leave_error = spans.leave_error * pace;
  if (rays.start_ends) {
    const V error = V::load(rays.start_error + lane);
    const Truths<T> secondary = spans.crosses & (error >= zero);
    if (secondary.any())
      spans.near_start = secondary & near_surface(leaf, local.o, V(leaf.stretch) * error);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_KINDS_INL_H_
