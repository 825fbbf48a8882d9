#include "tracer/intersect_exact.h"

#include <array>
#include <limits>
#include <utility>

#include "tracer/bounded.h"
#include "tracer/numeric.h"

namespace sir {
namespace {

template <typename S>
using Number = Bounded<S>;
template <typename S>
using Triple = std::array<Number<S>, 3>;

// The problem, and the powers of two that bring it near 1: one for the matrix and
// the way from the solid's origin, another for the direction.
template <typename T>
struct Problem {
  const Placement& placement;
  glm::vec<3, T> origin, direction;
  int size, speed;
  int t_exponent() const { return size - speed; }
};

template <typename T>
int exponent_of_largest(const glm::vec<3, T>& v) {
  const T largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? std::ilogb(largest) : std::numeric_limits<int>::min() / 2;
}

template <typename T>
bool finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// x times 2^exponent without error; false where it does not fit. What is wider
// than a double is the sum of its leading digits and the rest.
template <typename T>
bool scale(T x, int exponent, Number<DoubleDouble>& result) {
  using Wider = AtLeastDouble<T>;
  const Wider scaled = std::ldexp(Wider(x), exponent);
  const double leading = double(scaled);
  if (!std::isfinite(leading) || std::ldexp(scaled, -exponent) != Wider(x)) return false;
  const Wider rest = scaled - Wider(leading);
  result = {{leading, double(rest)}, 0};
  return Wider(double(rest)) == rest;
}
template <typename T>
bool scale(T x, int exponent, Number<Wide>& result) {
  if constexpr (kWiderThanDouble<T>) {
    // Near 1 no part of it is too small or too large for a double.
    const int shift = x == 0 ? 0 : std::ilogb(x);
    Wide sum;
    for (T rest = std::ldexp(x, -shift); rest != 0;) {
      const double leading = double(rest);
      sum = sum + Wide(leading);
      rest -= T(leading);
    }
    result = {times_power_of_two(sum, shift + exponent), 0};
  } else {
    result = {times_power_of_two(Wide(double(x)), exponent), 0};
  }
  return true;
}

// The nearest T to x times 2^exponent, but for a last rounding.
template <typename T, typename S>
T nearest(const S& x, int exponent) {
  if constexpr (kWiderThanDouble<T>) return nearest_wider<T>(x, exponent);
  else return static_cast<T>(to_double(times_power_of_two(x, exponent)));
}

template <typename S>
Number<S> dot(const Triple<S>& a, const Triple<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A boundary that the line crosses.
template <typename S>
struct End {
  Number<S> t;
  std::uint8_t face = 0;
};

template <typename S>
class ExactIntersection {
 public:
  template <typename T>
  ExactIntersection(PrimitiveKind kind, const Problem<T>& problem) : kind_(kind) {
    std::array<Triple<S>, 3> column;
    Triple<S> way, direction;
    bool fits = true;
    for (int r = 0; r < 3; ++r) {
      const auto at = static_cast<std::size_t>(r);
      for (int c = 0; c < 3; ++c)
        fits &= scale(problem.placement.linear[c][r], -problem.size,
                      column[static_cast<std::size_t>(c)][at]);
      Number<S> from, to;
      fits &= scale(problem.placement.translation[r], -problem.size, from);
      fits &= scale(problem.origin[r], -problem.size, to);
      way[at] = to - from;
      fits &= scale(problem.direction[r], -problem.speed, direction[at]);
    }
    if (!fits) decide_.doubt();
    std::array<Triple<S>, 3> row;  // of the adjugate
    for (std::size_t i = 0; i < 3; ++i) {
      const Triple<S>& a = column[(i + 1) % 3];
      const Triple<S>& b = column[(i + 2) % 3];
      for (std::size_t k = 0; k < 3; ++k)
        row[i][k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    unit_ = dot(column[0], row[0]);
    const bool mirrored = decide_.sign(unit_) < 0;
    if (mirrored) unit_ = -unit_;
    for (std::size_t i = 0; i < 3; ++i) {
      o_[i] = dot(row[i], way);
      d_[i] = dot(row[i], direction);
      if (mirrored) {
        o_[i] = -o_[i];
        d_[i] = -d_[i];
      }
    }
  }

  bool certain() const { return decide_.certain(); }

  template <typename T>
  bool run(int t_exponent, T resolution, Span<T>& span) {
    resolution_ = double(std::ldexp(AtLeastDouble<T>(resolution), -t_exponent));
    if (!candidates() || !certain()) return false;
    const std::size_t enter = latest(enters_, enter_count_, 1);
    const std::size_t leave = latest(leaves_, leave_count_, -1);
    if (!decide_.after(enters_[enter].t, leaves_[leave].t)) return false;
    span = {};
    span.enter = rounded<T>(enters_[enter].t, t_exponent);
    span.leave = rounded<T>(leaves_[leave].t, t_exponent);
    span.enter_face = lowest<T>(enters_, enter_count_, enter, t_exponent, span.enter);
    span.leave_face = lowest<T>(leaves_, leave_count_, leave, t_exponent, span.leave);
    return certain();
  }

 private:
  bool candidates() {
    switch (kind_) {
      case PrimitiveKind::cube: return slab(0, 0, 1) && slab(1, 2, 3) && slab(2, 4, 5);
      case PrimitiveKind::sphere: return sphere();
      case PrimitiveKind::cone: return cone();
      case PrimitiveKind::cylinder: return cylinder();
    }
    return false;
  }

  void enter_at(const Number<S>& t, std::uint8_t face) { enters_[enter_count_++] = known(t, face); }
  void leave_at(const Number<S>& t, std::uint8_t face) { leaves_[leave_count_++] = known(t, face); }

  // An end of which nothing is known, because numbers on the way to it were too large, could not
  // be compared with the others.
  End<S> known(const Number<S>& t, std::uint8_t face) {
    if (!std::isfinite(t.error)) decide_.doubt();
    return {t, face};
  }

  // 0 < coordinate < unit.
  bool slab(std::size_t axis, std::uint8_t low_face, std::uint8_t high_face) {
    const int way = decide_.sign(d_[axis]);
    if (way == 0) return decide_.sign(o_[axis]) > 0 && decide_.sign(unit_ - o_[axis]) > 0;
    const Number<S> at_low = -o_[axis] / d_[axis], at_high = (unit_ - o_[axis]) / d_[axis];
    enter_at(way > 0 ? at_low : at_high, way > 0 ? low_face : high_face);
    leave_at(way > 0 ? at_high : at_low, way > 0 ? high_face : low_face);
    return true;
  }

  // Both roots of a t^2 + 2bt + c, a not 0, given root = sqrt(b^2-ac), lower first.
  std::pair<Number<S>, Number<S>> roots(const Number<S>& a, const Number<S>& b, const Number<S>& c,
                                        const Number<S>& root) {
    // The sum that does not cancel; where b is all but 0 either will do.
    const Number<S> q = sign_of(b.value) > 0 ? -(b + root) : root - b;
    const Number<S> one = q / a, other = c / q;
    return sign_of(one.value - other.value) < 0 ? std::pair{one, other} : std::pair{other, one};
  }

  bool between_roots(const Number<S>& a, const Number<S>& b, const Number<S>& c,
                     const Number<S>& discriminant, std::uint8_t face) {
    if (decide_.sign(discriminant) <= 0) return false;
    const auto [low, high] = roots(a, b, c, square_root(discriminant));
    enter_at(low, face);
    leave_at(high, face);
    return true;
  }

  bool sphere() {
    const Number<S> a = dot(d_, d_), b = dot(o_, d_), square = unit_ * unit_;
    Triple<S> moment;
    for (std::size_t k = 0; k < 3; ++k)
      moment[k] = o_[(k + 1) % 3] * d_[(k + 2) % 3] - o_[(k + 2) % 3] * d_[(k + 1) % 3];
    return between_roots(a, b, dot(o_, o_) - square, a * square - dot(moment, moment), 0);
  }

  bool cylinder() {
    constexpr std::uint8_t kBottom = 0, kTop = 1, kSide = 2;
    if (!slab(1, kBottom, kTop)) return false;
    const Number<S> square = unit_ * unit_;
    const Number<S> a = d_[0] * d_[0] + d_[2] * d_[2], b = o_[0] * d_[0] + o_[2] * d_[2];
    const Number<S> c = o_[0] * o_[0] + o_[2] * o_[2] - square;
    if (decide_.sign(d_[0]) == 0 && decide_.sign(d_[2]) == 0) return decide_.sign(c) < 0;
    const Number<S> moment = o_[0] * d_[2] - o_[2] * d_[0];
    return between_roots(a, b, c, a * square - moment * moment, kSide);
  }

  bool cone() {
    constexpr std::uint8_t kSide = 0, kBase = 1;
    const Number<S>&x = o_[0], &y = o_[1], &z = o_[2];
    const Number<S>&dx = d_[0], &dw = d_[1], &dz = d_[2];
    const Number<S> w = y - unit_;  // puts the apex in the origin
    const int rising = decide_.sign(dw);
    if (rising == 0) {
      if (!(decide_.sign(y) > 0 && decide_.sign(w) < 0)) return false;
    } else if (rising > 0) {
      enter_at(-y / dw, kBase);
    } else {
      leave_at(-y / dw, kBase);
    }
    const Number<S> a = dx * dx + dz * dz - dw * dw, b = x * dx + z * dz - w * dw;
    const Number<S> c = x * x + z * z - w * w;
    const Number<S> xw = x * dw - w * dx, zw = z * dw - w * dz, xz = x * dz - z * dx;
    const Number<S> discriminant = xw * xw + zw * zw - xz * xz;
    const int flatter = decide_.sign(a);
    if (flatter > 0) {
      // One nappe, between the roots: the lower where w < 0 half-way.
      return between_roots(a, b, c, discriminant, kSide) && decide_.sign(dx * xw + dz * zw) > 0;
    }
    if (flatter < 0) {
      // Both nappes, outside between the roots; through the apex these are one.
      const bool apart = decide_.sign(discriminant) > 0;
      Number<S> reached = -b / a;
      if (apart) {
        const auto [low, high] = roots(a, b, c, square_root(discriminant));
        reached = rising < 0 ? high : low;
      }
      if (rising < 0) enter_at(reached, kSide);
      else leave_at(reached, kSide);
      return true;
    }
    // Parallel to a generator: 2bt + c < 0 on one half-line, which belongs to
    // the lower nappe where b and dw have one sign. b = 0 is tangent.
    if (decide_.sign(b) * rising <= 0) return false;
    const Number<S> root = -c / (b + b);
    if (rising < 0) enter_at(root, kSide);
    else leave_at(root, kSide);
    return true;
  }

  std::size_t latest(const std::array<End<S>, 4>& ends, std::size_t count, int direction) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < count; ++i)
      if (direction * sign_of(ends[i].t.value - ends[best].t.value) > 0) best = i;
    return best;
  }

  template <typename T>
  T rounded(const Number<S>& t, int exponent) {
    // Digits enough to round from, and no doubt about an exact 0.
    constexpr double kEnough = double(std::numeric_limits<AtLeastDouble<T>>::epsilon() / 16);
    if (t.error > std::max(kEnough * t.size(), resolution_) && decide_.sign(t) != 0)
      decide_.doubt();
    return nearest<T>(t.value, exponent);
  }

  template <typename T>
  std::uint8_t lowest(const std::array<End<S>, 4>& ends, std::size_t count, std::size_t named,
                      int exponent, T at) {
    std::uint8_t face = ends[named].face;
    for (std::size_t i = 0; i < count; ++i) {
      const T t = nearest<T>(ends[i].t.value, exponent);
      if (Numeric<T>::same_event(std::min(t, at), std::max(t, at)))
        face = std::min(face, ends[i].face);
    }
    return face;
  }

  PrimitiveKind kind_;
  Decisions<S> decide_;
  Number<S> unit_;
  Triple<S> o_, d_;  // SC_LOCAL in units of 1/unit_
  std::array<End<S>, 4> enters_, leaves_;
  std::size_t enter_count_ = 0, leave_count_ = 0;
  double resolution_ = 0;
};

}  // namespace

template <typename T>
bool intersect_exactly(PrimitiveKind kind, const Placement& placement, const RayCena<T>& ray,
                       T resolution, Span<T>& span) {
  const auto& m = placement.linear;
  const Problem<T> problem{
      placement, ray.origin.v, ray.direction.v,
      std::max({exponent_of_largest(m[0]), exponent_of_largest(m[1]), exponent_of_largest(m[2])}),
      exponent_of_largest(ray.direction.v)};
  if (!finite(problem.origin) || !finite(problem.direction) ||
      problem.direction == glm::vec<3, T>(0))
    return false;
  ExactIntersection<DoubleDouble> usual(kind, problem);
  const bool crosses = usual.run(problem.t_exponent(), resolution, span);
  if (usual.certain()) return crosses;
  ExactIntersection<Wide> last(kind, problem);
  return last.run(problem.t_exponent(), resolution, span);
}

template bool intersect_exactly(PrimitiveKind, const Placement&, const RayCena<float>&, float,
                                Span<float>&);
template bool intersect_exactly(PrimitiveKind, const Placement&, const RayCena<double>&, double,
                                Span<double>&);
template bool intersect_exactly(PrimitiveKind, const Placement&, const RayCena<long double>&,
                                long double, Span<long double>&);

}  // namespace sir
