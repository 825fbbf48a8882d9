// INTERSECTA as textbooks have it: one 4x4 inverse, b^2 - 4ac, no bounds. For
// measuring what the robust way costs and saves; the tracer does not use it.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "tracer/intersect.h"
#include "tracer/scene.h"

namespace sir::bench {

template <typename T>
struct TextbookLeaf {
  PrimitiveKind kind;
  glm::mat<4, 4, T> inverse;

  TextbookLeaf(PrimitiveKind primitive, const Placement& placement) : kind(primitive) {
    glm::mat<4, 4, T> matrix{glm::mat<3, 3, T>(placement.linear)};
    matrix[3] = glm::vec<4, T>(glm::vec<3, T>(placement.translation), 1);
    inverse = glm::inverse(matrix);
  }
};

template <typename T>
bool slab(T o, T d, T& enter, T& leave) {
  if (d == 0) return o > 0 && o < 1;
  const T a = -o / d, b = (1 - o) / d;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
  return true;
}

template <typename T>
bool quadratic(T a, T b, T c, T& low, T& high) {
  const T discriminant = b * b - 4 * a * c;
  if (a == 0 || discriminant <= 0) return false;
  const T root = std::sqrt(discriminant);
  low = (-b - root) / (2 * a);
  high = (-b + root) / (2 * a);
  if (low > high) std::swap(low, high);
  return true;
}

/// The span of a line in SC_CENA, if there is one.
template <typename T>
bool intersect_as_in_textbooks(const TextbookLeaf<T>& leaf, const RayCena<T>& ray, T& enter,
                               T& leave) {
  const glm::vec<3, T> o(leaf.inverse * glm::vec<4, T>(ray.origin.v, 1));
  const glm::vec<3, T> d(leaf.inverse * glm::vec<4, T>(ray.direction.v, 0));
  enter = -std::numeric_limits<T>::infinity();
  leave = std::numeric_limits<T>::infinity();
  T low, high;
  switch (leaf.kind) {
    case PrimitiveKind::cube:
      if (!slab(o.x, d.x, enter, leave) || !slab(o.y, d.y, enter, leave) ||
          !slab(o.z, d.z, enter, leave))
        return false;
      break;
    case PrimitiveKind::sphere:
      if (!quadratic(glm::dot(d, d), 2 * glm::dot(o, d), glm::dot(o, o) - 1, enter, leave))
        return false;
      break;
    case PrimitiveKind::cylinder:
      if (!slab(o.y, d.y, enter, leave)) return false;
      if (d.x == 0 && d.z == 0) {
        if (o.x * o.x + o.z * o.z >= 1) return false;
        break;
      }
      if (!quadratic(d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z), o.x * o.x + o.z * o.z - 1,
                     low, high))
        return false;
      enter = std::max(enter, low);
      leave = std::min(leave, high);
      break;
    case PrimitiveKind::cone: {
      const T w = o.y - 1;
      if (!slab(o.y, d.y, enter, leave)) return false;
      const T a = d.x * d.x + d.z * d.z - d.y * d.y;
      if (!quadratic(a, 2 * (o.x * d.x + o.z * d.z - w * d.y), o.x * o.x + o.z * o.z - w * w, low,
                     high))
        return false;
      if (a > 0) {
        enter = std::max(enter, low);
        leave = std::min(leave, high);
      } else if (d.y < 0) {
        enter = std::max(enter, high);
      } else {
        leave = std::min(leave, low);
      }
      break;
    }
  }
  return enter < leave;
}

}  // namespace sir::bench
