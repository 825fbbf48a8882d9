#include "tracer/shade.h"

#include "tracer/ray_shadow.h"

namespace sir {
namespace {

// max(0,N.H)^n; a zero L + E (the light straight behind the surface's point as
// seen from the eye) has no direction and shines not. Rounding may lift N.H
// above 1, and a large n would make any number of that.
template <typename T>
T highlight(const Hit<T>& hit, VectorCena<T> light) {
  const VectorCena<T> half = light + hit.eye;
  const T size = length(half);
  if (!(size > 0)) return 0;
  const T cosine = std::min(T(1), std::max(T(0), dot(hit.normal, half) / size));
  return std::pow(cosine, hit.reflectance->exponent);
}

// The way to a light, and the cosine that it falls in with: 0 where the light
// does not count.
template <typename T>
struct Incidence {
  VectorCena<T> to_light;
  T distance, cosine;
  Incidence(const Hit<T>& hit, const PointLight<T>& source)
      : to_light(source.position - hit.point), distance(length(to_light)) {
    cosine = distance > 0 ? std::max(T(0), dot(hit.normal, to_light) / distance) : T(0);
  }
};

// The most that a light can bring: no shadow, and the highlight at its brightest.
template <typename T>
Colour<T> most_of(const Hit<T>& hit, const PointLight<T>& source, T cosine) {
  if (!(cosine > 0)) return Colour<T>(0);
  return source.intensity * (hit.reflectance->diffuse * cosine + hit.reflectance->specular);
}

}  // namespace

template <typename T>
Colour<T> shade(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                RayCounts& counts, std::vector<glm::dvec3>* log, PixelLedger<T>* ledger, T weight) {
  const Reflectance<T>& k = *hit.reflectance;
  const EffectSet& effects = model.effects;
  Colour<T> sum = model.ambient * k.ambient;
  if (ledger) {
    ledger->settle(Colour<T>(0), weight * sum);
    for (const PointLight<T>& source : model.lights)
      ledger->expect(weight * most_of(hit, source, Incidence<T>(hit, source).cosine));
  }
  for (const PointLight<T>& source : model.lights) {
    const Incidence<T> incidence(hit, source);
    const bool lit = incidence.cosine > 0;
    Colour<T> arriving(0), came(0);
    if (lit || (effects.exhaustive && incidence.distance > 0)) {
      arriving = source.intensity;
      const bool matters =
          effects.exhaustive || log || most_of(hit, source, incidence.cosine) != Colour<T>(0);
      if (effects.shadow && matters) {
        if (ledger && ledger->decided()) {
          ++counts.spared;
          continue;
        }
        arriving = light_reaching(model, classifier, hit, incidence.to_light, source);
        ++counts.shadow;
        counts.spans += classifier.spans();
      }
    }
    if (!lit) arriving = Colour<T>(0);
    if (log) log->push_back(glm::dvec3(arriving));
    if (lit && arriving != Colour<T>(0)) {
      Colour<T> factor = k.diffuse * incidence.cosine;
      if (effects.highlight && k.specular > 0)
        factor += k.specular * highlight(hit, incidence.to_light * (1 / incidence.distance));
      came = arriving * factor;
      sum += came;
    }
    if (ledger) ledger->settle(weight * most_of(hit, source, incidence.cosine), weight * came);
  }
  return sum;
}

template Colour<float> shade(const Model<float>&, Classifier<float>&, const Hit<float>&, RayCounts&,
                             std::vector<glm::dvec3>*, PixelLedger<float>*, float);
template Colour<double> shade(const Model<double>&, Classifier<double>&, const Hit<double>&,
                              RayCounts&, std::vector<glm::dvec3>*, PixelLedger<double>*, double);

}  // namespace sir
