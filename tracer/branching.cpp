#include "tracer/branching.h"

#include "tracer/ray_secondary.h"

namespace sir {

template <typename T>
Branching<T> branching_at(const Model<T>& model, const Hit<T>& hit, T index) {
  const Reflectance<T>& k = *hit.reflectance;
  const EffectSet& effects = model.effects;
  Branching<T> made;
  // A ray that begins inside is in what it leaves; a face without an index says
  // nothing of it, and its mirrored ray is as unknowing.
  if (index == 0) index = hit.boundary.entering ? T(1) : k.index;
  made.index = index;
  made.index_beyond = hit.boundary.entering && k.index > 0 ? k.index : T(1);
  made.mirror_weight = effects.reflection ? k.specular : T(0);
  made.through_weight = effects.refraction ? k.transmission : T(0);
  if (!effects.refraction || !(made.through_weight > 0 || effects.exhaustive)) return made;
  made.has_through = refracted(hit.incident, hit.normal, index > 0 ? index : T(1),
                               made.index_beyond, made.through);
  if (!made.has_through) {  // the transmitted share joins the mirrored ray
    made.total_reflection = made.through_weight > 0;
    made.mirror_weight += made.through_weight;
    made.through_weight = 0;
  }
  return made;
}

#define SIR_INSTANTIATE(T) template Branching<T> branching_at(const Model<T>&, const Hit<T>&, T);
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
