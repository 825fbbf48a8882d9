#include "tracer/hit.h"

namespace sir {

template <typename T>
const Reflectance<T>& reflectance_at(const Model<T>& model, const Boundary<T>& boundary,
                                     PointCena<T> point) {
  return reflectance_on(model, boundary.leaf, boundary.face,
                        [&] { return model.solid.leaves[boundary.leaf].placement.unapply(point); });
}

template <typename T>
Hit<T> hit_at(const Model<T>& model, const RayCena<T>& ray, const Boundary<T>& boundary) {
  const Leaf<T>& leaf = model.solid.leaves[boundary.leaf];
  Hit<T> hit;
  hit.boundary = boundary;
  hit.point = ray.at(boundary.t);
  hit.incident = normalize(ray.direction);
  hit.eye = -hit.incident;
  const PointLocal<T> local = leaf.placement.unapply(hit.point);
  const auto outward = leaf.placement.apply(outward_normal(leaf.kind, boundary.face, local));
  hit.normal = normalize(VectorCena<T>{outward.v});
  if (dot(hit.normal, hit.eye) < 0) hit.normal = -hit.normal;
  hit.reflectance = &reflectance_at(model, boundary, hit.point);
  hit.error = Numeric<T>::kStartRoundings * Numeric<T>::kEpsilon *
                  (largest(ray.origin.v) + boundary.t * largest(ray.direction.v)) +
              boundary.error * largest(ray.direction.v);
  return hit;
}

#define SIR_INSTANTIATE(T)                                                           \
  template const Reflectance<T>& reflectance_at(const Model<T>&, const Boundary<T>&, \
                                                PointCena<T>);                       \
  template Hit<T> hit_at(const Model<T>&, const RayCena<T>&, const Boundary<T>&);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
