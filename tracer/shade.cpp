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

}  // namespace

template <typename T>
Colour<T> shade(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                RayCounts& counts, std::vector<glm::dvec3>* log) {
  const Reflectance<T>& k = *hit.reflectance;
  const EffectSet& effects = model.effects;
  Colour<T> sum = model.ambient * k.ambient;
  for (const PointLight<T>& source : model.lights) {
    const VectorCena<T> to_light = source.position - hit.point;
    const T distance = length(to_light);
    const T cosine = distance > 0 ? dot(hit.normal, to_light) / distance : T(0);
    const bool lit = cosine > 0;
    Colour<T> arriving(0);
    if (lit || (effects.exhaustive && distance > 0)) {
      arriving = source.intensity;
      if (effects.shadow) {
        arriving = light_reaching(model, classifier, hit, to_light, arriving);
        ++counts.shadow;
        counts.spans += classifier.spans();
      }
    }
    if (!lit) arriving = Colour<T>(0);
    if (log) log->push_back(glm::dvec3(arriving));
    if (!lit || arriving == Colour<T>(0)) continue;
    Colour<T> factor = k.diffuse * cosine;
    if (effects.highlight && k.specular > 0)
      factor += k.specular * highlight(hit, to_light * (1 / distance));
    sum += arriving * factor;
  }
  return sum;
}

template Colour<float> shade(const Model<float>&, Classifier<float>&, const Hit<float>&, RayCounts&,
                             std::vector<glm::dvec3>*);
template Colour<double> shade(const Model<double>&, Classifier<double>&, const Hit<double>&,
                              RayCounts&, std::vector<glm::dvec3>*);

}  // namespace sir
