#include "tests/exact_solids.h"

#include <utility>

namespace sir::test {
namespace {

// A root (u + sign sqrt(d)) / a with a > 0; sign = 0: rational.
struct Root {
  Dyadic u, d, a;
  int sign = 0;
};

// The sign of x - y. Two irrational ones are always of the same quadratic.
int compare(const Root& x, const Root& y) {
  if (x.sign != 0 && y.sign != 0) return x.sign - y.sign;
  const Dyadic rational = x.u * y.a - y.u * x.a;
  if (x.sign != 0) return sign_with_root(rational, Dyadic(x.sign) * y.a, x.d);
  if (y.sign != 0) return sign_with_root(rational, Dyadic(-y.sign) * x.a, y.d);
  return rational.sign();
}

struct Bound {
  Root root;
  Real t;
  int face;
};

// The intersection of half-lines and intervals.
class Constraints {
 public:
  void rule_out() { empty_ = true; }

  // low < origin + t direction < high.
  void between(const Dyadic& origin, const Dyadic& direction, const Dyadic& low, const Dyadic& high,
               int low_face, int high_face) {
    above(origin - low, direction, low_face);
    above(high - origin, -direction, high_face);
  }

  // value + t slope > 0.
  void above(const Dyadic& value, const Dyadic& slope, int face) {
    if (slope.sign() == 0) {
      if (value.sign() <= 0) empty_ = true;
      return;
    }
    const bool rises = slope.sign() > 0;
    Root root;
    root.u = rises ? -value : value;
    root.a = rises ? slope : -slope;
    const Real t = root.u.real() / root.a.real();
    (rises ? enters_ : leaves_).push_back({root, t, face});
  }

  // One root of a t^2 + 2 b t + c = 0, the lower or the upper; a != 0 and the
  // discriminant d >= 0.
  void root_of(Dyadic a, Dyadic b, Dyadic c, const Dyadic& d, bool upper, bool enters, int face) {
    if (a.sign() < 0) {
      a = -a;
      b = -b;
      c = -c;
    }
    Root root;
    root.u = -b;
    root.a = a;
    root.d = d;
    root.sign = upper ? 1 : -1;
    // -b + sign sqrt(d) cancels where the signs differ; c over the other root
    // does not.
    const Real sqrt_d = sqrt(d.real());
    const bool adds = root.u.sign() * root.sign >= 0;
    const Real sum = adds ? root.u.real() + root.sign * sqrt_d : root.u.real() - root.sign * sqrt_d;
    const Real t = adds ? sum / a.real() : c.real() / sum;
    (enters ? enters_ : leaves_).push_back({root, t, face});
  }

  ExactSpan span() const {
    ExactSpan result;
    if (empty_) return result;
    for (const Bound& enter : enters_)
      for (const Bound& leave : leaves_)
        if (compare(enter.root, leave.root) >= 0) return result;
    result.hit = !enters_.empty() && !leaves_.empty();
    for (const Bound& bound : enters_) result.enters.push_back({bound.t, bound.face});
    for (const Bound& bound : leaves_) result.leaves.push_back({bound.t, bound.face});
    return result;
  }

 private:
  std::vector<Bound> enters_, leaves_;
  bool empty_ = false;
};

// Inside a t^2 + 2 b t + c < 0 where a > 0: between the roots.
void between_roots(Constraints& inside, const Dyadic& a, const Dyadic& b, const Dyadic& c,
                   int face) {
  const Dyadic d = squared(b) - a * c;
  if (d.sign() <= 0) return inside.rule_out();
  inside.root_of(a, b, c, d, false, true, face);
  inside.root_of(a, b, c, d, true, false, face);
}

Dyadic dot(const Dyadic3& a, const Dyadic3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// x^2 + z^2 < (y - apex)^2 with y < apex; margin moves base and apex.
void cone(Constraints& inside, const HomogeneousRay& ray, const Dyadic& margin) {
  constexpr int kSide = 0, kBase = 1;
  const Dyadic x = ray.origin[0], z = ray.origin[2], dx = ray.direction[0], dz = ray.direction[2];
  const Dyadic w = ray.origin[1] - (ray.unit + margin + margin), dw = ray.direction[1];
  inside.above(ray.origin[1] + margin, dw, kBase);
  const Dyadic a = dx * dx + dz * dz - dw * dw;
  const Dyadic b = x * dx + z * dz - w * dw;
  const Dyadic c = x * x + z * z - w * w;
  if (a.sign() > 0) {
    // Both roots are on one nappe: the lower one where w < 0 between them.
    if ((a * w - b * dw).sign() >= 0) return inside.rule_out();
    between_roots(inside, a, b, c, kSide);
  } else if (a.sign() < 0) {
    // Inside before the lower root and behind the upper; the lower nappe is
    // where w goes to minus infinity. Through the apex both are one.
    const bool falls = dw.sign() < 0;
    inside.root_of(a, b, c, squared(b) - a * c, falls, falls, kSide);
  } else {
    // Parallel to a generator: 2 b t + c < 0, a half-line in one nappe.
    if (b.sign() == 0 || b.sign() != dw.sign()) return inside.rule_out();
    inside.above(-c, -(b + b), kSide);
  }
}

}  // namespace

ExactPlacement::ExactPlacement(const Placement& placement) {
  // m[row][column] of p' = m p + translation; glm keeps columns.
  std::array<Dyadic3, 3> m;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          placement.linear[column][row];
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3;
      const std::size_t c1 = (row + 1) % 3, c2 = (row + 2) % 3;
      adjugate[row][column] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    }
    translation[row] = placement.translation[static_cast<int>(row)];
  }
  determinant = m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
  if (determinant.sign() < 0) {
    determinant = -determinant;
    for (Dyadic3& row : adjugate)
      for (Dyadic& entry : row) entry = -entry;
  }
}

HomogeneousRay ExactPlacement::to_local(const glm::dvec3& origin,
                                        const glm::dvec3& direction) const {
  Dyadic3 from, along;
  for (std::size_t i = 0; i < 3; ++i) {
    from[i] = Dyadic(origin[static_cast<int>(i)]) - translation[i];
    along[i] = direction[static_cast<int>(i)];
  }
  HomogeneousRay ray;
  for (std::size_t i = 0; i < 3; ++i) {
    ray.origin[i] = dot(adjugate[i], from);
    ray.direction[i] = dot(adjugate[i], along);
  }
  ray.unit = determinant;
  return ray;
}

ExactSpan exact_span(PrimitiveKind kind, const HomogeneousRay& ray, double margin_local) {
  const Dyadic3 &o = ray.origin, &d = ray.direction;
  const Dyadic margin = Dyadic(margin_local) * ray.unit;
  const Dyadic low = -margin, high = ray.unit + margin;
  Constraints inside;
  switch (kind) {
    case PrimitiveKind::cube:
      for (std::size_t i = 0; i < 3; ++i)
        inside.between(o[i], d[i], low, high, static_cast<int>(2 * i), static_cast<int>(2 * i + 1));
      break;
    case PrimitiveKind::sphere:
      between_roots(inside, dot(d, d), dot(o, d), dot(o, o) - high * high, 0);
      break;
    case PrimitiveKind::cylinder: {
      inside.between(o[1], d[1], low, high, 0, 1);
      const Dyadic a = d[0] * d[0] + d[2] * d[2], c = o[0] * o[0] + o[2] * o[2] - high * high;
      if (a.sign() > 0) between_roots(inside, a, o[0] * d[0] + o[2] * d[2], c, 2);
      else if (c.sign() >= 0) inside.rule_out();
      break;
    }
    case PrimitiveKind::cone: cone(inside, ray, margin); break;
  }
  return inside.span();
}

bool exactly_inside(PrimitiveKind kind, const HomogeneousRay& ray, double t) {
  Dyadic3 p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = ray.origin[i] + Dyadic(t) * ray.direction[i];
  const Dyadic& one = ray.unit;
  const auto strictly_in_01 = [&](const Dyadic& v) { return v.sign() > 0 && (one - v).sign() > 0; };
  const auto less = [](const Dyadic& a, const Dyadic& b) { return (b - a).sign() > 0; };
  switch (kind) {
    case PrimitiveKind::cube:
      return strictly_in_01(p[0]) && strictly_in_01(p[1]) && strictly_in_01(p[2]);
    case PrimitiveKind::sphere: return less(dot(p, p), squared(one));
    case PrimitiveKind::cylinder:
      return strictly_in_01(p[1]) && less(squared(p[0]) + squared(p[2]), squared(one));
    case PrimitiveKind::cone:
      return strictly_in_01(p[1]) && less(squared(p[0]) + squared(p[2]), squared(p[1] - one));
  }
  return false;
}

}  // namespace sir::test
