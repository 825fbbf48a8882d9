// One transform in SC_CENA (cria_matriz and processa_transformação, thesis 3.2.2.2).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "tracer/scene.h"

namespace sir::modeler {

/// p' = c + (p - c) M + d for every point p of a solid. What SC_LOCAL and SC_CENA have to do with
/// each other is changed by appending it: p' = p LOCAL_CENA T.
struct Step {
  enum class Kind { translation, scale, rotation, matrix };
  Kind kind = Kind::matrix;
  glm::dmat3 linear{1.0};       ///< M as in Placement: column i is line i of the matrix
  glm::dvec3 translation{0.0};  ///< d
  glm::dvec3 centre{0.0};       ///< c
};

Step translation_by(const glm::dvec3& way);

/// About the origin until `centre` is set. Factors may be negative, which mirrors.
Step scale_by(const glm::dvec3& factors);

/// About an axis (0: X, 1: Y, 2: Z), counter-clockwise for one who looks from the axis's positive
/// end; 90 takes X to Y about Z. Multiples of 90 and 30 degrees are exact: their sines and cosines
/// are 0, 1/2 and 1, never 6e-17.
Step rotation_about(int axis, double degrees);

/// Any matrix, four lines of three numbers as in the .CSG, the fourth the translation.
Step matrix_of(const Placement& lines);

/// LOCAL_CENA T. A number that comes out as -0 becomes 0, but where T is a matrix and LOCAL_CENA
/// the identity: then the result is T bit for bit.
Placement appended(const Placement& local_cena, const Step& step);

/// Whether a matrix can be that of a solid: all numbers finite and the 3x3 part invertible.
bool is_usable(const Placement& local_cena);

/// CENA_LOCAL: lines as in LOCAL_CENA.
Placement inverse_of(const Placement& local_cena);

}  // namespace sir::modeler
