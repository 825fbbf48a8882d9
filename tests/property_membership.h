// Whether a point lies in a solid, from the file's own numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/scene.h"

namespace sir::test {

__extension__ typedef __float128 Quad;

enum class Side : std::uint8_t { outside, inside, undecided };

/// Decides by inequalities in quadruple precision, with no intersection, no
/// root and no order of hits: a second opinion on what the tracer says of a
/// point between two of its boundaries. The inverse of a placement is kept as
/// adjugate and determinant of the file's doubles.
class Membership {
 public:
  explicit Membership(const Scene& scene);

  /// The side of `point`, undecided where the point is nearer to a surface
  /// that matters than 4096 roundings of size `epsilon` can explain: in
  /// SC_LOCAL, 4096 epsilon (1 + stretch extent), for a point worked out from
  /// coordinates of size `extent`. About 1e-12 in double.
  Side of(const glm::dvec3& point, double extent, double epsilon) const;

 private:
  struct Leaf {
    PrimitiveKind kind;
    std::array<Quad, 9> adjugate;  // row by row
    Quad determinant;
    std::array<double, 9> inverse;  // the same, rounded: decides what is not near
    glm::dvec3 translation;
    double stretch;  // largest row sum of |inverse|
  };
  struct Step {
    bool leaf;
    Operation operation;
    std::size_t index;
  };

  static Side side_of(const Leaf& leaf, const glm::dvec3& point, double extent, double epsilon);

  std::vector<Leaf> leaves_;
  std::vector<Step> steps_;  // reverse Polish
};

}  // namespace sir::test
