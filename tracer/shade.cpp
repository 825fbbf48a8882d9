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

// The most that a light can bring: it falls in straight, there is no shadow, and
// the highlight is at its brightest.
template <typename T>
Colour<T> most_of(const Reflectance<T>& k, const PointLight<T>& source) {
  return source.intensity * (k.diffuse + k.specular);
}

}  // namespace

template <typename T>
Colour<T> shade(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                RayCounts& counts, std::vector<glm::dvec3>* log, PixelLedger<T>* ledger, T weight) {
  const Reflectance<T>& k = *hit.reflectance;
  const EffectSet& effects = model.effects;
  Colour<T> sum = model.ambient * k.ambient;
  if (ledger) {
    Colour<T> most(0);
    for (const PointLight<T>& source : model.lights) most += most_of(k, source);
    ledger->expect(weight * most, static_cast<T>(model.lights.size()));
    ledger->settle(Colour<T>(0), weight * sum);
  }
  for (const PointLight<T>& source : model.lights) {
    const VectorCena<T> to_light = source.position - hit.point;
    const T distance = length(to_light);
    const T cosine = distance > 0 ? dot(hit.normal, to_light) / distance : T(0);
    const bool lit = cosine > 0;
    const Colour<T> most = most_of(k, source);
    const bool asked = effects.exhaustive ? distance > 0 : lit && (log || most != Colour<T>(0));
    Colour<T> arriving(0), came(0);
    if (asked) {
      arriving = source.intensity;
      if (effects.shadow) {
        if (ledger && ledger->decided()) {
          ++counts.spared;
          continue;
        }
        arriving = light_reaching(model, classifier, hit, to_light, source);
        ++counts.shadow;
        if (arriving != source.intensity && arriving != Colour<T>(0)) ++counts.filtered;
        counts.spans += classifier.spans();
      }
    }
    if (!lit) arriving = Colour<T>(0);
    if (log) log->push_back(glm::dvec3(arriving));
    if (lit && arriving != Colour<T>(0)) {
      Colour<T> factor = k.diffuse * cosine;
      if (effects.highlight && k.specular > 0)
        factor += k.specular * highlight(hit, to_light * (1 / distance));
      came = arriving * factor;
      sum += came;
    }
    if (ledger) ledger->settle(weight * most, weight * came);
  }
  return sum;
}

template Colour<float> shade(const Model<float>&, Classifier<float>&, const Hit<float>&, RayCounts&,
                             std::vector<glm::dvec3>*, PixelLedger<float>*, float);
template Colour<double> shade(const Model<double>&, Classifier<double>&, const Hit<double>&,
                              RayCounts&, std::vector<glm::dvec3>*, PixelLedger<double>*, double);
template Colour<long double> shade(const Model<long double>&, Classifier<long double>&,
                                   const Hit<long double>&, RayCounts&, std::vector<glm::dvec3>*,
                                   PixelLedger<long double>*, long double);

}  // namespace sir
