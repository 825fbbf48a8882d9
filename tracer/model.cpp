#include "tracer/model.h"

namespace sir {
template <typename T>
Model<T>::Model(const Scene& scene, const EffectSet& allowed, Formulas formulas)
    : solid(build_solid<T>(scene, formulas)),
      laid_out(lay_out(solid)),
      camera(scene.camera),
      background(scene.lighting.background),
      ambient(scene.lighting.ambient),
      effects(effects_called_for(scene, allowed)) {
  for (const Surface& surface : scene.surfaces) textures.emplace_back(surface);
  for (const Light& light : scene.lighting.lights)
    lights.push_back({{glm::vec<3, T>(light.position)}, Colour<T>(light.intensity)});
  // Asked for only where nothing lets light through (see light_reaching()).
  if (effects.shadow && !effects.filter)
    for (PointLight<T>& light : lights) light.clearance = clearance(solid, light.position);
}

template struct Model<float>;
template struct Model<double>;
template struct Model<long double>;

}  // namespace sir
