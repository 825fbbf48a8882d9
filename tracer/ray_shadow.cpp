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
  return light_through(model, classifier, ray, start, light);
}

template <typename T>
Colour<T> light_through(const Model<T>& model, Classifier<T>& classifier, const RayCena<T>& ray,
                        const RayStart<T>& start, const PointLight<T>& light) {
  classifier.begin(ray, start, T(1));
  T passed = 1;
  Boundary<T> boundary;
  while (classifier.next(boundary) && boundary.t < 1 && !Numeric<T>::same_event(boundary.t, T(1))) {
    const T kt = reflectance_at(model, boundary, ray.at(boundary.t)).transmission;
    if (!(kt > 0)) return Colour<T>(0);
    passed *= kt;
  }
  return light.intensity * passed;
}

#define SIR_INSTANTIATE(T)                                                                         \
  template Colour<T> light_reaching(const Model<T>&, Classifier<T>&, const Hit<T>&, VectorCena<T>, \
                                    const PointLight<T>&);                                         \
  template Colour<T> light_through(const Model<T>&, Classifier<T>&, const RayCena<T>&,             \
                                   const RayStart<T>&, const PointLight<T>&);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
