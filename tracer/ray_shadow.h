// Illumination rays (thesis 2.4.1): how much of a light reaches a point.
#pragma once

#include "tracer/hit.h"

namespace sir {

/// The light's intensity at the hit: none behind an opaque surface, else times
/// the kt of every boundary between. `to_light` = light - point, not
/// normalised, so that the light is at t = 1; a surface that the light lies on
/// is not between. Without the filter effect any surface is opaque, and the ray
/// is not followed further than to the knowledge that there is one.
template <typename T>
Colour<T> light_reaching(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                         VectorCena<T> to_light, const PointLight<T>& light);

/// The same with the filter effect for a ray from `start` to the light at t = 1 that
/// is known to meet something: all boundaries, in order.
template <typename T>
Colour<T> light_through(const Model<T>& model, Classifier<T>& classifier, const RayCena<T>& ray,
                        const RayStart<T>& start, const PointLight<T>& light);

}  // namespace sir
