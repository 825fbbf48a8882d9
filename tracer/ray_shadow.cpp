#include "tracer/ray_shadow.h"

namespace sir {

template <typename T>
Colour<T> light_reaching(const Model<T>& model, Classifier<T>& classifier, const Hit<T>& hit,
                         VectorCena<T> to_light, const PointLight<T>& light) {
  const RayCena<T> ray{hit.point, to_light};
  if (!model.effects.filter)
    return classifier.blocked(ray, hit.leaving_on_eye_side(), light.clearance) ? Colour<T>(0)
                                                                               : light.intensity;
  Boundary<T> boundary;
  const auto between = [&] { return boundary.t < 1 && !Numeric<T>::same_event(boundary.t, T(1)); };
  const auto transmission = [&] {
    return reflectance_at(model, boundary, ray.at(boundary.t)).transmission;
  };
  // Most rays meet nothing, or something opaque: only glass needs the whole list.
  const RayStart<T> start = hit.leaving_on_eye_side();
  if (model.solid.leaves.size() > Classifier<T>::kFew) {
    if (!classifier.first(ray, start, boundary, T(1)) || !between()) return light.intensity;
    if (!(transmission() > 0)) return Colour<T>(0);
  }
  classifier.begin(ray, start, T(1));
  T passed = 1;
  while (classifier.next(boundary) && between()) {
    const T kt = transmission();
    if (!(kt > 0)) return Colour<T>(0);
    passed *= kt;
  }
  return light.intensity * passed;
}

template Colour<float> light_reaching(const Model<float>&, Classifier<float>&, const Hit<float>&,
                                      VectorCena<float>, const PointLight<float>&);
template Colour<double> light_reaching(const Model<double>&, Classifier<double>&,
                                       const Hit<double>&, VectorCena<double>,
                                       const PointLight<double>&);
template Colour<long double> light_reaching(const Model<long double>&, Classifier<long double>&,
                                            const Hit<long double>&, VectorCena<long double>,
                                            const PointLight<long double>&);

}  // namespace sir
