// Backward error of a computed t (ExactOracle::backward_error).
#include <cmath>

#include "tests/exact_oracle.h"

namespace sir::test {
namespace {

using Real3 = std::array<Real, 3>;

// The face's equation at p in SC_LOCAL; its gradient goes to `slope`.
Real equation(PrimitiveKind kind, int face, const Real3& p, Real3& slope) {
  slope = {0, 0, 0};
  const auto plane = [&](std::size_t axis, int at) {
    slope[axis] = 1;
    return p[axis] - at;
  };
  switch (kind) {
    case PrimitiveKind::cube: return plane(static_cast<std::size_t>(face / 2), face % 2);
    case PrimitiveKind::sphere:
      slope = {2 * p[0], 2 * p[1], 2 * p[2]};
      return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1;
    case PrimitiveKind::cone:
      if (face == 1) return plane(1, 0);
      slope = {2 * p[0], -2 * (p[1] - 1), 2 * p[2]};
      return p[0] * p[0] + p[2] * p[2] - (p[1] - 1) * (p[1] - 1);
    case PrimitiveKind::cylinder:
      if (face < 2) return plane(1, face);
      slope = {2 * p[0], 0, 2 * p[2]};
      return p[0] * p[0] + p[2] * p[2] - 1;
  }
  return 0;
}

}  // namespace

ExactOracle::Backward ExactOracle::backward_error(std::size_t node_index, int face,
                                                  const glm::dvec3& origin,
                                                  const glm::dvec3& direction, double t) const {
  const CsgNode& node = scene_.tree.nodes[node_index];
  const ExactPlacement placement(node.placement);
  const HomogeneousRay ray = placement.to_local(origin, direction);
  const Real unit = ray.unit.real();
  Real3 p, slope;
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = (ray.origin[i] + Dyadic(t) * ray.direction[i]).real() / unit;
  const Real value = equation(node.kind, face, p, slope);

  // Of p = M^-1 (o + t d - translation): dp = M^-1 (do + t dd - dtranslation - dM p).
  Real moved = 0, speed = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const int k = static_cast<int>(j);
    Real normal = 0;
    for (std::size_t i = 0; i < 3; ++i) normal += slope[i] * placement.adjugate[i][j].real() / unit;
    Real size = abs(Real(origin[k])) + abs(Real(t) * Real(direction[k])) +
                abs(Real(node.placement.translation[k]));
    for (int column = 0; column < 3; ++column)
      size += abs(Real(node.placement.linear[column][k]) * p[static_cast<std::size_t>(column)]);
    moved += abs(normal) * size;
    speed += normal * Real(direction[k]);
  }
  moved = ldexp(moved, -53);
  Backward result{0, 0};
  if (value != 0)
    result.roundings = moved == 0 ? HUGE_VAL : Real(abs(value) / moved).convert_to<double>();
  if (speed != 0) result.one_rounding = Real(moved / abs(speed)).convert_to<double>();
  return result;
}

}  // namespace sir::test
