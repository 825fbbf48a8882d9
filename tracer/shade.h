// SHADE (thesis 2.4.3, equation 2.1): the light that a surface itself sends
// back; what mirrored and refracted rays bring is added by Tracer.
#pragma once

#include <vector>

#include "tracer/hit.h"
#include "tracer/pixel_ledger.h"
#include "tracer/ray_counts.h"

namespace sir {

/// How a light's rays fall on a hit.
template <typename T>
struct Incidence {
  VectorCena<T> to_light;  ///< light - point
  T distance, cosine;      ///< of to_light; N.L, 0 at the light itself

  Incidence(PointCena<T> point, VectorCena<T> normal, PointCena<T> light)
      : to_light(light - point),
        distance(length(to_light)),
        cosine(distance > 0 ? dot(normal, to_light) / distance : T(0)) {}
};

/// N.H within [0,1]; below 0 where L + E is zero (the light straight behind the
/// surface's point as seen from the eye): that has no direction, and shines not.
/// Rounding may lift N.H above 1, and a large n would make any number of that.
template <typename T>
T gleam_of(VectorCena<T> eye, VectorCena<T> normal, const Incidence<T>& incidence) {
  const VectorCena<T> half = incidence.to_light * (1 / incidence.distance) + eye;
  const T size = length(half);
  return size > 0 ? std::min(T(1), std::max(T(0), dot(normal, half) / size)) : T(-1);
}

/// The most that a light can bring: it falls in straight, there is no shadow, and
/// the highlight is at its brightest.
template <typename T>
Colour<T> most_of(const Reflectance<T>& k, const PointLight<T>& source) {
  return source.intensity * (k.diffuse + k.specular);
}

/// Kd N.L + Ks max(0,N.H)^n where N.L > 0. `gleam`: see gleam_of(); it is asked for
/// where there are highlights and Ks > 0 only.
template <typename T>
Colour<T> sent_back(const EffectSet& effects, const Reflectance<T>& k, T cosine, T gleam) {
  Colour<T> factor = k.diffuse * cosine;
  if (effects.highlight && k.specular > 0 && gleam >= 0)
    factor += k.specular * std::pow(gleam, k.exponent);
  return factor;
}

/// Ia Ka + sum over lights If [Kd max(0,N.L) + Ks max(0,N.H)^n], L, E, H and N
/// unit, H = normalize(L+E). A light counts only where N.L > 0. Casts the
/// shadow rays; `counts.shadow` is raised for each. `log`, if given, receives
/// the intensity that arrives from each light.
///
/// With a ledger the light is entered there times `weight`, its share in the
/// pixel; once the ledger has decided no shadow ray is cast (`counts.spared`
/// instead) and the result is too small by what does not matter.
template <typename T>
Colour<T> shade(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                RayCounts& counts, std::vector<glm::dvec3>* log = nullptr,
                PixelLedger<T>* ledger = nullptr, T weight = 1);

}  // namespace sir
