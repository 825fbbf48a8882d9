// Directions of mirrored and refracted rays (thesis 2.4.1).
#pragma once

#include "tracer/frames.h"

namespace sir {

/// R = I - 2 (N.I) N for unit I and N.
template <typename T>
VectorCena<T> mirrored(VectorCena<T> incident, VectorCena<T> normal);

/// Snell's law for unit I, unit N on the incident side and indices n1 (where
/// the ray is) and n2 (beyond). False: total internal reflection.
/// The sine is taken as |I + cN| and 1 - sin^2 as a product: the thesis's
/// 1/(N.I) overflows at grazing angles and 1 - eta^2 (1 - c^2) cancels near the
/// critical one.
template <typename T>
bool refracted(VectorCena<T> incident, VectorCena<T> normal, T n1, T n2, VectorCena<T>& direction);

}  // namespace sir
