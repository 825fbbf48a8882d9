#include "tracer/branching.h"

#include "tracer/ray_secondary.h"

namespace sir {

template <typename T>
Branching<T> branching_before_refraction(const EffectSet& effects, const Reflectance<T>& k,
                                         bool entering, T index, bool& asks) {
  Branching<T> made;
  // A ray that begins inside is in what it leaves; a face without an index says
  // nothing of it, and its mirrored ray is as unknowing.
  if (index == 0) index = entering ? T(1) : k.index;
  made.index = index;
  made.index_beyond = entering && k.index > 0 ? k.index : T(1);
  made.mirror_weight = effects.reflection ? k.specular : T(0);
  made.through_weight = effects.refraction ? k.transmission : T(0);
  asks = effects.refraction && (made.through_weight > 0 || effects.exhaustive);
  return made;
}

template <typename T>
Branching<T> branching_at(const Model<T>& model, const Hit<T>& hit, T index) {
  bool asks = false;
  auto made = branching_before_refraction(model.effects, *hit.reflectance, hit.boundary.entering,
                                          index, asks);
  if (!asks) return made;
  made.has_through = refracted(hit.incident, hit.normal, refraction_index(made.index),
                               made.index_beyond, made.through);
  if (!made.has_through) made.reflect_totally();
  return made;
}

#define SIR_INSTANTIATE(T)                                                                         \
  template Branching<T> branching_before_refraction(const EffectSet&, const Reflectance<T>&, bool, \
                                                    T, bool&);                                     \
  template Branching<T> branching_at(const Model<T>&, const Hit<T>&, T);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
