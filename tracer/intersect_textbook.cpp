#include "tracer/intersect_textbook.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/matrix.hpp>

namespace sir {
namespace {

// What is left of the line, and the faces at its ends. Choices are written so that
// they compile to selections: which way they go is anyone's guess.
template <typename T>
class Rest {
 public:
  void enter_at(T t, std::uint8_t face) {
    enter_face_ = t > enter_ ? face : enter_face_;
    enter_ = std::max(enter_, t);
  }
  void leave_at(T t, std::uint8_t face) {
    leave_face_ = t < leave_ ? face : leave_face_;
    leave_ = std::min(leave_, t);
  }
  // 0 < coordinate < 1; false where a parallel line lies outside.
  bool slab(T o, T d, std::uint8_t low_face, std::uint8_t high_face) {
    if (d == 0) return o > 0 && o < 1;
    const T a = -o / d, b = (1 - o) / d;
    const bool down = d < 0;
    enter_at(std::min(a, b), down ? high_face : low_face);
    leave_at(std::max(a, b), down ? low_face : high_face);
    return true;
  }
  bool to_span(Span<T>& span) const {
    span = {enter_,
            leave_,
            0,
            0,
            static_cast<std::uint8_t>(enter_face_),
            static_cast<std::uint8_t>(leave_face_)};
    return enter_ < leave_;
  }

 private:
  T enter_ = -std::numeric_limits<T>::infinity(), leave_ = std::numeric_limits<T>::infinity();
  int enter_face_ = 0, leave_face_ = 0;
};

// Roots of a t^2 + b t + c, lower first.
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

}  // namespace

template <typename T>
TextbookLeaf<T>::TextbookLeaf(PrimitiveKind primitive, const Placement& placement)
    : kind(primitive) {
  glm::mat<4, 4, T> matrix{glm::mat<3, 3, T>(placement.linear)};
  matrix[3] = glm::vec<4, T>(glm::vec<3, T>(placement.translation), 1);
  inverse = glm::inverse(matrix);
}

template <typename T>
bool intersect_as_in_textbooks(const TextbookLeaf<T>& leaf, const RayCena<T>& ray, Span<T>& span) {
  const glm::vec<3, T> o(leaf.inverse * glm::vec<4, T>(ray.origin.v, 1));
  const glm::vec<3, T> d(leaf.inverse * glm::vec<4, T>(ray.direction.v, 0));
  Rest<T> rest;
  T low, high;
  switch (leaf.kind) {
    case PrimitiveKind::cube:
      if (!rest.slab(o.x, d.x, 0, 1) || !rest.slab(o.y, d.y, 2, 3) || !rest.slab(o.z, d.z, 4, 5))
        return false;
      break;
    case PrimitiveKind::sphere:
      if (!quadratic(glm::dot(d, d), 2 * glm::dot(o, d), glm::dot(o, o) - 1, low, high))
        return false;
      rest.enter_at(low, 0);
      rest.leave_at(high, 0);
      break;
    case PrimitiveKind::cylinder: {
      constexpr std::uint8_t kBottom = 0, kTop = 1, kSide = 2;
      if (!rest.slab(o.y, d.y, kBottom, kTop)) return false;
      if (d.x == 0 && d.z == 0) {
        if (o.x * o.x + o.z * o.z >= 1) return false;
        break;
      }
      if (!quadratic(d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z), o.x * o.x + o.z * o.z - 1,
                     low, high))
        return false;
      rest.enter_at(low, kSide);
      rest.leave_at(high, kSide);
      break;
    }
    case PrimitiveKind::cone: {
      constexpr std::uint8_t kSide = 0, kBase = 1;
      const T w = o.y - 1;  // puts the apex in the origin
      if (!rest.slab(o.y, d.y, kBase, kBase)) return false;
      const T a = d.x * d.x + d.z * d.z - d.y * d.y;
      if (!quadratic(a, 2 * (o.x * d.x + o.z * d.z - w * d.y), o.x * o.x + o.z * o.z - w * w, low,
                     high))
        return false;
      if (a > 0) {
        rest.enter_at(low, kSide);
        rest.leave_at(high, kSide);
      } else if (d.y < 0) {
        rest.enter_at(high, kSide);  // the lower nappe lies beyond the root where w falls
      } else {
        rest.leave_at(low, kSide);
      }
      break;
    }
  }
  return rest.to_span(span);
}

#define SIR_INSTANTIATE(T)         \
  template struct TextbookLeaf<T>; \
  template bool intersect_as_in_textbooks(const TextbookLeaf<T>&, const RayCena<T>&, Span<T>&);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
