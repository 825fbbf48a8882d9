#include "modeler/step.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "tracer/numeric.h"

namespace sir::modeler {
namespace {

struct Turn {
  double sine, cosine;
};

// Of an angle in [0, 45] degrees.
Turn turn_within_octant(double degrees) {
  if (degrees == 0) return {0, 1};
  if (degrees == 30) return {0.5, std::sqrt(0.75)};
  const double radians = degrees * (std::numbers::pi / 180);
  return {std::sin(radians), std::cos(radians)};
}

// The quarter turns are taken off in degrees, where they are exact.
Turn turn_by(double degrees) {
  double rest = std::fmod(degrees, 360.0);
  if (rest < 0) rest += 360;
  const int quarters = static_cast<int>(rest / 90) % 4;
  rest -= 90.0 * static_cast<int>(rest / 90);
  Turn turn = turn_within_octant(rest <= 45 ? rest : 90 - rest);
  if (rest > 45) std::swap(turn.sine, turn.cosine);
  for (int i = 0; i < quarters; ++i) turn = {turn.cosine, -turn.sine};
  return turn;
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

Step translation_by(const glm::dvec3& way) {
  Step step;
  step.kind = Step::Kind::translation;
  step.translation = way;
  return step;
}

Step scale_by(const glm::dvec3& factors) {
  Step step;
  step.kind = Step::Kind::scale;
  for (int axis = 0; axis < 3; ++axis) step.linear[axis][axis] = factors[axis];
  return step;
}

Step rotation_about(int axis, double degrees) {
  const Turn turn = turn_by(degrees);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  Step step;
  step.kind = Step::Kind::rotation;
  step.linear[next][next] = turn.cosine;
  step.linear[next][last] = turn.sine;
  step.linear[last][next] = -turn.sine;
  step.linear[last][last] = turn.cosine;
  return step;
}

Step matrix_of(const Placement& lines) {
  Step step;
  step.linear = lines.linear;
  step.translation = lines.translation;
  return step;
}

Placement appended(const Placement& local_cena, const Step& step) {
  constexpr glm::dvec3 kPlus(0.0);  // -0 + 0 = 0
  Placement result = local_cena;
  switch (step.kind) {
    case Step::Kind::translation:
      result.translation = local_cena.translation + step.translation + kPlus;
      return result;
    case Step::Kind::scale: {
      // Not as a product of matrices: an entry takes one rounding, and a zero stays one.
      const glm::dvec3 factors(step.linear[0][0], step.linear[1][1], step.linear[2][2]);
      for (int line = 0; line < 3; ++line)
        result.linear[line] = local_cena.linear[line] * factors + kPlus;
      result.translation = (local_cena.translation - step.centre) * factors + step.centre + kPlus;
      return result;
    }
    case Step::Kind::matrix:
      if (local_cena.linear == glm::dmat3(1.0) && local_cena.translation == glm::dvec3(0.0) &&
          step.centre == glm::dvec3(0.0))
        return {step.linear, step.translation};
      [[fallthrough]];
    case Step::Kind::rotation: break;
  }
  for (int line = 0; line < 3; ++line)
    result.linear[line] = step.linear * local_cena.linear[line] + kPlus;
  result.translation =
      step.linear * (local_cena.translation - step.centre) + step.centre + step.translation + kPlus;
  return result;
}

bool is_usable(const Placement& local_cena) {
  return is_finite(local_cena.linear[0]) && is_finite(local_cena.linear[1]) &&
         is_finite(local_cena.linear[2]) && is_finite(local_cena.translation) &&
         is_invertible(local_cena.linear);
}

Placement inverse_of(const Placement& local_cena) {
  Inverse inverse;
  invert(local_cena.linear, inverse);
  Placement result;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) result.linear[column][row] = inverse.entry(row, column) + 0.0;
  result.translation = -(result.linear * local_cena.translation) + glm::dvec3(0.0);
  return result;
}

}  // namespace sir::modeler
