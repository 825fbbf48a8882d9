#include "tracer/bounds.h"

namespace sir {
namespace {

// Half the extent of the set {linear (x,0,z) : x^2+z^2 <= 1} along each axis.
template <typename T>
glm::vec<3, T> disc_extent(const glm::mat<3, 3, T>& linear) {
  glm::vec<3, T> extent;
  for (int axis = 0; axis < 3; ++axis) extent[axis] = std::hypot(linear[0][axis], linear[2][axis]);
  return extent;
}

}  // namespace

template <typename T>
Bounds<T> tight_bounds_of(PrimitiveKind kind, const LocalCena<T>& placement) {
  const auto& m = placement.linear;
  const auto& origin = placement.translation;
  Bounds<T> box;
  switch (kind) {
    case PrimitiveKind::cube:
      box.low = box.high = origin;
      for (int edge = 0; edge < 3; ++edge) {
        box.low += glm::min(m[edge], glm::vec<3, T>(0));
        box.high += glm::max(m[edge], glm::vec<3, T>(0));
      }
      break;
    case PrimitiveKind::sphere:
      for (int axis = 0; axis < 3; ++axis) {
        const T extent = std::hypot(std::hypot(m[0][axis], m[1][axis]), m[2][axis]);
        box.low[axis] = origin[axis] - extent;
        box.high[axis] = origin[axis] + extent;
      }
      break;
    case PrimitiveKind::cone: {
      const auto disc = disc_extent(m), apex = origin + m[1];
      box.low = glm::min(origin - disc, apex);
      box.high = glm::max(origin + disc, apex);
      break;
    }
    case PrimitiveKind::cylinder: {
      const auto disc = disc_extent(m), top = origin + m[1];
      box.low = glm::min(origin, top) - disc;
      box.high = glm::max(origin, top) + disc;
      break;
    }
  }
  return box;
}

template <typename T>
Bounds<T> bounds_of(PrimitiveKind kind, const LocalCena<T>& placement) {
  Bounds<T> box = tight_bounds_of(kind, placement);
  for (int axis = 0; axis < 3; ++axis) {
    // The terms that were summed count, not the sum: they may have cancelled.
    const T size =
        std::abs(placement.translation[axis]) + std::abs(box.low[axis]) + std::abs(box.high[axis]);
    const T widening = Numeric<T>::kBoxRoundings * Numeric<T>::kEpsilon * size;
    box.low[axis] -= widening;
    box.high[axis] += widening;
  }
  return box;
}

template Bounds<float> tight_bounds_of(PrimitiveKind, const LocalCena<float>&);
template Bounds<double> tight_bounds_of(PrimitiveKind, const LocalCena<double>&);
template Bounds<long double> tight_bounds_of(PrimitiveKind, const LocalCena<long double>&);
template Bounds<float> bounds_of(PrimitiveKind, const LocalCena<float>&);
template Bounds<double> bounds_of(PrimitiveKind, const LocalCena<double>&);
template Bounds<long double> bounds_of(PrimitiveKind, const LocalCena<long double>&);

}  // namespace sir
