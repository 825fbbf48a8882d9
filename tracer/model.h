// A scene made ready for tracing in one scalar type (BASICO's initialisation,
// thesis 3.3).
#pragma once

#include <memory>
#include <vector>

#include "tracer/camera.h"
#include "tracer/colour.h"
#include "tracer/effect_set.h"
#include "tracer/packet_solid.h"
#include "tracer/solid.h"
#include "tracer/texture.h"

namespace sir {

template <typename T>
struct PointLight {
  PointCena<T> position;
  Colour<T> intensity;
  T clearance = 0;  ///< no primitive that adds to the solid is nearer, along any axis
};

/// Everything that tracing reads. Immutable; shared by all threads.
template <typename T>
struct Model {
  Solid<T> solid;
  std::shared_ptr<const PacketSolid<T>> laid_out;  ///< the solid for packets, or null
  Camera<T> camera;
  std::vector<Texture<T>> textures;  ///< index as in Scene::surfaces
  std::vector<PointLight<T>> lights;
  Colour<T> background, ambient;
  EffectSet effects;  ///< those that the scene calls for

  Model(const Scene& scene, const EffectSet& allowed, Formulas formulas = Formulas::robust);
};

}  // namespace sir
