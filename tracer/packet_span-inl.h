// INTERSECTA for a chunk of a packet: tracer/intersect_*.cpp and Leaf::to_local()
// with every branch a mask, every number the same to the last bit. Comments on the
// mathematics stand there.
#if defined(SIR_TRACER_PACKET_SPAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_SPAN_INL_H_
#undef SIR_TRACER_PACKET_SPAN_INL_H_
#else
#define SIR_TRACER_PACKET_SPAN_INL_H_
#endif

#include "tracer/interval.h"
#include "tracer/packet_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

/// Span and Crossing of each lane; the others miss.
template <typename T>
struct Spans {
  Numbers<T> enter, leave, enter_error, leave_error;
  Codes<T> enter_face, leave_face;
  Truths<T> crosses, unsure;
  Truths<T> near_start;  ///< crossed, and a secondary ray's start may lie on its surface
};

/// LocalRay.
template <typename T>
struct LocalRays {
  Numbers<T> o[3], d[3], o_error[3], d_error[3];
};

template <typename T>
struct Places {
  Numbers<T> t, error;
};

// A row of a matrix, times v; or of its entries' magnitudes.
template <typename T, bool kDiagonal>
HWY_INLINE Numbers<T> row_of(const T* columns, int row, const Numbers<T>* v) {
  using V = Numbers<T>;
  if constexpr (kDiagonal) return V(columns[4 * row]) * v[row];
  return V(columns[row]) * v[0] + V(columns[3 + row]) * v[1] + V(columns[6 + row]) * v[2];
}
template <typename T, bool kDiagonal>
HWY_INLINE Numbers<T> row_of_sizes(const T* columns, int row, const Numbers<T>* v) {
  using V = Numbers<T>;
  if constexpr (kDiagonal) return abs(V(columns[4 * row])) * v[row];
  return abs(V(columns[row])) * v[0] + abs(V(columns[3 + row])) * v[1] +
         abs(V(columns[6 + row])) * v[2];
}

// `kDiagonal`: as if the other entries were not there. That changes nothing but
// the signs of zeros.
template <typename T, bool kDiagonal>
HWY_INLINE void to_local(const PacketLeaf<T>& leaf, const ReadyPacket<T>& rays, std::size_t lane,
                         LocalRays<T>& local) {
  using V = Numbers<T>;
  V o[3], d[3], way[3], size[3];
  for (int axis = 0; axis < 3; ++axis) {
    o[axis] = V::load(rays.origin[axis] + lane) - V(leaf.translation[axis]);
    d[axis] = V::load(rays.paced[axis] + lane) * V(leaf.pace);
    way[axis] = abs(o[axis]) + V(leaf.translation_slack[axis]);
    size[axis] = abs(d[axis]);
  }
  for (int row = 0; row < 3; ++row) {
    local.o[row] = row_of<T, kDiagonal>(leaf.numerators, row, o);
    local.d[row] = row_of<T, kDiagonal>(leaf.numerators, row, d);
    local.o_error[row] =
        V(leaf.origin_weight[row]) * row_of_sizes<T, kDiagonal>(leaf.numerators, row, way);
    local.d_error[row] =
        V(leaf.direction_weight[row]) * row_of_sizes<T, kDiagonal>(leaf.numerators, row, size);
  }
  if (leaf.divided)
    for (int row = 0; row < 3; ++row) {
      local.o[row] = local.o[row] / V(leaf.divisors[row]);
      local.d[row] = local.d[row] / V(leaf.divisors[row]);
    }
}

/// moderate().
template <typename T>
HWY_INLINE Truths<T> moderate(Numbers<T> origin, Numbers<T> origin_error, Numbers<T> direction,
                              Numbers<T> direction_error) {
  using V = Numbers<T>;
  constexpr T kMost = Numeric<T>::kModerate;
  return (origin + origin_error < V(kMost)) & (direction < V(kMost)) & (direction > V(1 / kMost)) &
         (direction_error * V(T(64)) < direction);
}

/// Quadratic.
template <typename T>
struct Quadratics {
  Numbers<T> a, b, c, discriminant;
  Numbers<T> a_error, b_error, c_error, discriminant_error;

  HWY_INLINE Truths<T> roots(Places<T>& low, Places<T>& high) const {
    using V = Numbers<T>;
    constexpr T u = kUnitRoundoff<T>;
    Truths<T> known = (discriminant > V(T(16)) * discriminant_error) & (abs(a) > V(T(4)) * a_error);
    const V root = sqrt(discriminant);
    const V q = select(b > V(T(0)), -(b + root), root - b);
    const V size = abs(q);
    const V q_error = b_error + discriminant_error / root + V(3 * u) * size;
    known &= size > V(T(4)) * q_error;
    const Places<T> one = quotient(q, q_error, a, a_error);
    const Places<T> other = quotient(c, c_error, q, q_error);
    const Truths<T> swapped = one.t > other.t;
    low = {select(swapped, other.t, one.t), select(swapped, other.error, one.error)};
    high = {select(swapped, one.t, other.t), select(swapped, one.error, other.error)};
    return known;
  }

 private:
  static HWY_INLINE Places<T> quotient(Numbers<T> n, Numbers<T> n_error, Numbers<T> d,
                                       Numbers<T> d_error) {
    using V = Numbers<T>;
    const V t = n / d, size = abs(t);
    return {t, V(T(1.4)) * (n_error + size * d_error) / abs(d) + V(2 * kUnitRoundoff<T>) * size};
  }
};

/// Interval.
template <typename T>
class Intervals {
  using V = Numbers<T>;

 public:
  // Spelt out: the compiler's own would not be for this instruction set.
  HWY_INLINE Intervals()
      : enter_{V(-kInfinity), V(T(0))},
        leave_{V(kInfinity), V(T(0))},
        enter_rival_(-kInfinity),
        leave_rival_(kInfinity),
        enter_face_(0u),
        leave_face_(0u) {}

  HWY_INLINE void enter_at(Truths<T> where, Places<T> at, Codes<T> face) {
    const Truths<T> better = where & (at.t > enter_.t);
    const V rival = select(better, enter_.t + enter_.error, at.t + at.error);
    enter_rival_ = select(where, max_of(enter_rival_, rival), enter_rival_);
    enter_ = {select(better, at.t, enter_.t), select(better, at.error, enter_.error)};
    enter_face_ = select(better, face, enter_face_);
  }
  HWY_INLINE void leave_at(Truths<T> where, Places<T> at, Codes<T> face) {
    const Truths<T> better = where & (at.t < leave_.t);
    const V rival = select(better, leave_.t - leave_.error, at.t - at.error);
    leave_rival_ = select(where, min_of(leave_rival_, rival), leave_rival_);
    leave_ = {select(better, at.t, leave_.t), select(better, at.error, leave_.error)};
    leave_face_ = select(better, face, leave_face_);
  }

  /// What a test of several answers leaves open.
  struct Answer {
    Truths<T> crosses, misses;  ///< the others are unsure
  };

  HWY_INLINE Answer slab(const PacketLeaf<T>& leaf, const LocalRays<T>& ray, int axis,
                         std::uint32_t low_face, std::uint32_t high_face) {
    const V o = ray.o[axis], d = ray.d[axis];
    const V o_error = ray.o_error[axis], d_error = ray.d_error[axis];
    const V unit(leaf.unit), unit_error(leaf.unit_error);
    const V zero(T(0));
    const Truths<T> parallel = (d == zero) & (d_error == zero);
    Answer answer{(abs(d) > V(kSteep) * d_error) - parallel, Truths<T>::none()};
    const Places<T> low = plane(-o, o_error, d, d_error);
    const Places<T> high = plane(unit - o, o_error + unit_error, d, d_error);
    const Truths<T> up = d > zero;
    const Codes<T> low_code(low_face), high_code(high_face);
    enter_at(answer.crosses, {select(up, low.t, high.t), select(up, low.error, high.error)},
             select(up, low_code, high_code));
    leave_at(answer.crosses, {select(up, high.t, low.t), select(up, high.error, low.error)},
             select(up, high_code, low_code));
    if (HWY_UNLIKELY(parallel.any())) {
      const Answer inside =
          inside_slab(min_of(o, unit - o), o_error + unit_error + V(2 * kUnitRoundoff<T>) * unit);
      answer.crosses |= parallel & inside.crosses;
      answer.misses = parallel & inside.misses;
    }
    return answer;
  }

  static HWY_INLINE Answer inside_slab(V depth, V error) {
    const Truths<T> crosses = depth > error;
    return {crosses, (depth < -error) - crosses};
  }

  static HWY_INLINE Places<T> plane(V distance, V distance_error, V d, V d_error) {
    const V t = distance / d, size = abs(t);
    return {t, V(T(1.04)) * (distance_error + size * d_error) / abs(d) +
                   V(T(2.1) * kUnitRoundoff<T>) * size};
  }
  static constexpr T kSteep = Interval<T>::kSteep;

  /// `where`: the lanes that got that far.
  HWY_INLINE void to_spans(Truths<T> where, Spans<T>& spans) const {
    const V gap = leave_.t - enter_.t, error = enter_.error + leave_.error;
    const Truths<T> open = gap > error;
    spans.unsure |= (where - open) - (gap < -error);
    const Truths<T> apart = (enter_.t - enter_rival_ > enter_.error + same_event(enter_.t)) &
                            (leave_rival_ - leave_.t > leave_.error + same_event(leave_.t));
    spans.unsure |= (where & open) - apart;
    spans.crosses = where & open & apart;
    spans.enter = enter_.t;
    spans.leave = leave_.t;
    spans.enter_error = enter_.error;
    spans.leave_error = leave_.error;
    spans.enter_face = enter_face_;
    spans.leave_face = leave_face_;
  }

 private:
  static HWY_INLINE V same_event(V t) {
    return V(2 * Numeric<T>::kCoincidentUlps * Numeric<T>::kEpsilon) * abs(t);
  }

  static constexpr T kInfinity = std::numeric_limits<T>::infinity();
  Places<T> enter_, leave_;
  V enter_rival_, leave_rival_;
  Codes<T> enter_face_, leave_face_;
};

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_SPAN_INL_H_
