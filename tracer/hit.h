// A point where a ray meets the solid: a node of the thesis's ARV_INTER.
#pragma once

#include "tracer/classify.h"
#include "tracer/model.h"

namespace sir {

template <typename T>
struct Hit {
  Boundary<T> boundary;
  PointCena<T> point;
  VectorCena<T> incident;  ///< unit, along the ray
  VectorCena<T> eye;       ///< unit, towards the ray's origin (E)
  VectorCena<T> normal;    ///< unit, on E's side (N)
  const Reflectance<T>* reflectance = nullptr;
  T error = 0;  ///< how far rounding may have moved the point, in SC_CENA

  /// The start of a secondary ray from here: on E's side of the surface
  /// (mirrored and shadow rays) or on the other (refracted rays).
  RayStart<T> leaving_on_eye_side() const {
    return {boundary.leaf, !boundary.leaf_entering, error};
  }
  RayStart<T> leaving_through() const { return {boundary.leaf, boundary.leaf_entering, error}; }
};

/// Works out a boundary found along a ray: point, normal, texture.
template <typename T>
Hit<T> hit_at(const Model<T>& model, const RayCena<T>& ray, const Boundary<T>& boundary);

/// The coefficients of a leaf's face; `local()` is the point on it in SC_LOCAL, and
/// asked for where they depend on that only.
template <typename T, typename Local>
const Reflectance<T>& reflectance_on(const Model<T>& model, std::uint32_t leaf, std::uint8_t face,
                                     Local&& local) {
  const Leaf<T>& of = model.solid.leaves[leaf];
  const Texture<T>& texture = model.textures[of.surfaces[face]];
  if (texture.uniform() || !model.effects.texture) return texture.first();
  return texture.at(texture_uv(of.kind, face, local()), true);
}

/// The coefficients of the surface at a boundary, without the rest.
template <typename T>
const Reflectance<T>& reflectance_at(const Model<T>& model, const Boundary<T>& boundary,
                                     PointCena<T> point);

}  // namespace sir
