#include "tracer/interval.h"

namespace sir {

template <typename T>
bool intersect_cone(const RayLocal<T>& ray, T unit, Span<T>& span) {
  constexpr std::uint8_t kSide = 0, kBase = 1;
  // w = y - unit puts the apex in the origin: x^2 + z^2 < w^2, w in (-unit, 0).
  const T x = ray.origin.v.x, w = ray.origin.v.y - unit, z = ray.origin.v.z;
  const T dx = ray.direction.v.x, dw = ray.direction.v.y, dz = ray.direction.v.z;

  Interval<T> inside;
  if (dw == 0) {
    if (!(ray.origin.v.y > 0 && w < 0)) return false;
  } else {
    // From y, not from w: the difference may have been rounded.
    const T base = -ray.origin.v.y / dw;
    if (dw > 0) inside.enter_at(base, kBase);
    else inside.leave_at(base, kBase);
    // Below the apex, whatever rounding makes of a ray along a generator.
    const T apex = -w / dw;
    if (dw > 0) inside.leave_at(apex, kSide);
    else inside.enter_at(apex, kSide);
  }

  const T a = dx * dx + dz * dz - dw * dw;
  const T b = x * dx + z * dz - w * dw;
  const T c = x * x + z * z - w * w;
  // b^2 - a c as minors, which do not cancel away from tangency.
  const T xw = x * dw - w * dx, zw = z * dw - w * dz, xz = x * dz - z * dx;
  const T discriminant = xw * xw + zw * zw - xz * xz;

  if (a > 0) {
    // Flatter than the generators: one nappe, between the roots.
    if (!(discriminant > 0)) return false;
    const Roots<T> roots(a, b, c, std::sqrt(discriminant));
    if (!(w + (roots.low / 2 + roots.high / 2) * dw < 0)) return false;  // the upper nappe
    inside.enter_at(roots.low, kSide);
    inside.leave_at(roots.high, kSide);
  } else if (a < 0) {
    // Steeper: through both nappes, outside between the roots. The lower nappe
    // lies beyond the root on the side where w falls. A ray through the apex
    // (discriminant 0) still enters.
    const T root = std::sqrt(std::max(discriminant, T(0)));
    const T q = b > 0 ? -(b + root) : root - b;
    const T one = q / a, other = q == 0 ? one : c / q;
    if (dw < 0) inside.enter_at(std::max(one, other), kSide);
    else inside.leave_at(std::min(one, other), kSide);
  } else {
    // Parallel to a generator: 2 b t + c < 0 on one half-line, which belongs to
    // the lower nappe where b and dw have one sign. b = 0 is tangent.
    if (!(b * dw > 0)) return false;
    const T root = -c / (2 * b);
    if (dw < 0) inside.enter_at(root, kSide);
    else inside.leave_at(root, kSide);
  }
  return inside.to_span(span);
}

template bool intersect_cone(const RayLocal<float>&, float, Span<float>&);
template bool intersect_cone(const RayLocal<double>&, double, Span<double>&);

}  // namespace sir
