#include "tracer/ray_secondary.h"

#include <algorithm>
#include <cmath>

namespace sir {

template <typename T>
VectorCena<T> mirrored(VectorCena<T> incident, VectorCena<T> normal) {
  return normalize(incident - normal * (2 * dot(normal, incident)));
}

template <typename T>
bool refracted(VectorCena<T> incident, VectorCena<T> normal, T n1, T n2, VectorCena<T>& direction) {
  if (n1 == n2) {
    direction = incident;  // an index of 1 changes nothing, not even a rounding
    return true;
  }
  const T cosine = std::max(T(0), -dot(normal, incident));
  const VectorCena<T> tangent = incident + normal * cosine;  // its length is sin of the angle
  const T eta = n1 / n2;
  const T sine = eta * length(tangent);
  const T square = (1 - sine) * (1 + sine);
  if (square < 0) return false;
  direction = normalize(tangent * eta - normal * std::sqrt(square));
  return true;
}

#define SIR_INSTANTIATE(T)                                       \
  template VectorCena<T> mirrored(VectorCena<T>, VectorCena<T>); \
  template bool refracted(VectorCena<T>, VectorCena<T>, T, T, VectorCena<T>&);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
