#include "tracer/shade.h"

#include "tracer/ray_shadow.h"

namespace sir {
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
    const Incidence<T> incidence(hit.point, hit.normal, source.position);
    const bool lit = incidence.cosine > 0;
    const Colour<T> most = most_of(k, source);
    const bool asked =
        effects.exhaustive ? incidence.distance > 0 : lit && (log || most != Colour<T>(0));
    Colour<T> arriving(0), came(0);
    if (asked) {
      arriving = source.intensity;
      if (effects.shadow) {
        if (ledger && ledger->decided()) {
          ++counts.spared;
          continue;
        }
        arriving = light_reaching(model, classifier, hit, incidence.to_light, source);
        ++counts.shadow;
        if (arriving != source.intensity && arriving != Colour<T>(0)) ++counts.filtered;
        counts.spans += classifier.spans();
      }
    }
    if (!lit) arriving = Colour<T>(0);
    if (log) log->push_back(glm::dvec3(arriving));
    if (lit && arriving != Colour<T>(0)) {
      const bool shiny = effects.highlight && k.specular > 0;
      const T gleam = shiny ? gleam_of(hit.eye, hit.normal, incidence) : T(-1);
      came = arriving * sent_back(effects, k, incidence.cosine, gleam);
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
