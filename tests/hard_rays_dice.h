// What the makers of hard rays share: a generator, short vectors with exact
// relations between them, placements, aiming.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "tests/hard_rays.h"
#include "tests/scene_builder.h"

namespace sir::test {

/// Random numbers by integer arithmetic.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool coin() { return below(2) == 0; }
  int sign() { return coin() ? 1 : -1; }
  double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }  ///< in [0,1)
  double real(double low, double high) { return low + (high - low) * real(); }
  glm::dvec3 reals(double low, double high);
  /// Integers in [-size,size], not all zero.
  glm::dvec3 integers(int size);

 private:
  std::mt19937_64 random_;
};

/// The double nearest to 10^k.
double ten(int k);

/// A point of the unit sphere, numerator / denominator: its length is rational.
struct Quadruple {
  glm::dvec3 numerator;
  double denominator;
};
Quadruple quadruple(Dice& dice);  ///< x^2 + y^2 + z^2 = d^2, signs and order random
/// The same with y = 0: a point of the unit circle of cone and cylinder.
Quadruple triple(Dice& dice);

/// A vector of short integers at a right angle to `normal`, exactly.
glm::dvec3 across(Dice& dice, const glm::dvec3& normal);

/// Any matrix of small integers with a determinant other than zero, times `factor`,
/// moved by small integers: images of short numbers are exact.
Placement short_placement(Dice& dice, double factor = 1);
/// Turned, scaled unequally within [size/2, size], moved within [-2,2] size: nothing
/// is exact.
Placement general_placement(Dice& dice, double size = 1);
/// Scaled along the axes by small integers or halves, moved by such.
Placement aligned_placement(Dice& dice);
/// A rotation: a quaternion of small integers, divided by its length at the end.
glm::dmat3 rotation(Dice& dice);

glm::dvec3 to_scene(const Placement& placement, const glm::dvec3& point);

/// A point well inside a primitive, in short numbers.
glm::dvec3 inner_point(Dice& dice, PrimitiveKind kind);

inline constexpr std::array<PrimitiveKind, 3> kQuadrics = {
    PrimitiveKind::sphere, PrimitiveKind::cone, PrimitiveKind::cylinder};
inline constexpr std::array<PrimitiveKind, 4> kKinds = {
    PrimitiveKind::cube, PrimitiveKind::sphere, PrimitiveKind::cone, PrimitiveKind::cylinder};
inline constexpr std::array<Operation, 3> kOperations = {Operation::union_of, Operation::difference,
                                                         Operation::intersection};

using Shared = std::shared_ptr<const Scene>;

/// A scene of one primitive.
Shared alone(PrimitiveKind kind, const Placement& placement);
/// A scene of two, with node numbers in random order.
struct Part {
  PrimitiveKind kind;
  Placement placement;
};
Shared pair_of(Dice& dice, Operation operation, const Part& left, const Part& right);

/// A ray through a point along a direction, from `back` directions before it;
/// point and direction in SC_CENA, or in a primitive's SC_LOCAL. Exact as long as
/// the numbers are short. Given in braces, whose order of evaluation is fixed.
struct Aim {
  Aim(Shared scene, const glm::dvec3& point, const glm::dvec3& direction, double back);
  Aim(Shared scene, const Placement& placement, const glm::dvec3& point,
      const glm::dvec3& direction, double back);
  HardRay ray;
};
HardRay through(const Aim& aim);

/// A list of classes put together.
void append(std::vector<HardClass>& to, const std::vector<HardClass>& from);

}  // namespace sir::test
