// Where a line crosses one primitive, decided exactly: the contract's table of
// primitives in rational arithmetic, sharing nothing with the tracer.
#pragma once

#include <array>
#include <vector>

#include "tests/exact_number.h"
#include "tracer/scene.h"

namespace sir::test {

using Dyadic3 = std::array<Dyadic, 3>;

/// SC_LOCAL's ray times the determinant of LOCAL_CENA, so that no division is
/// needed: local coordinate i is (origin[i] + t direction[i]) / unit, unit > 0.
struct HomogeneousRay {
  Dyadic3 origin, direction;
  Dyadic unit;
};

/// LOCAL_CENA's way back, without division: the adjugate and the determinant,
/// both turned so that the determinant is positive.
struct ExactPlacement {
  explicit ExactPlacement(const Placement& placement);
  HomogeneousRay to_local(const glm::dvec3& origin, const glm::dvec3& direction) const;

  std::array<Dyadic3, 3> adjugate;  ///< [row][column]
  Dyadic determinant;               ///< > 0
  Dyadic3 translation;
};

/// A place where the line crosses the surface that bears a face.
struct Crossing {
  Real t;
  int face;
};

/// The part of the whole line, t from minus to plus infinity, inside the open
/// set that the primitive is.
struct ExactSpan {
  bool hit = false;  ///< false also for touches and for lines in a face
  /// Every surface that the line crosses inwards, and outwards: the span is
  /// from the last of `enters` to the first of `leaves`.
  std::vector<Crossing> enters, leaves;
};

/// `margin`: the primitive is grown on every side by this much in SC_LOCAL
/// (shrunk where negative). Decisions are exact: signs of polynomials in the
/// inputs. Values of t are good to 98 digits.
ExactSpan exact_span(PrimitiveKind kind, const HomogeneousRay& ray, double margin = 0);

/// Whether the point at t lies in the open set, from the primitive's
/// inequalities alone; independent of exact_span().
bool exactly_inside(PrimitiveKind kind, const HomogeneousRay& ray, double t);

}  // namespace sir::test
