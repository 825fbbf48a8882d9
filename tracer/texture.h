// TEXTURA (thesis 2.4.4, 3.3): the coefficients of a surface at (u,v).
#pragma once

#include <vector>

#include "tracer/colour.h"
#include "tracer/scene.h"
#include "tracer/surface_point.h"

namespace sir {

/// Coefficients in the scalar type of the rays.
template <typename T>
struct Reflectance {
  Colour<T> ambient, diffuse;
  T specular, exponent, transmission, index;
};

/// A surface made ready for many points.
template <typename T>
class Texture {
 public:
  explicit Texture(const Surface& surface);

  /// LISA: one set. XADREZ: the first where
  /// min(floor(u nu),nu-1) + min(floor(v nv),nv-1) is even, else the second.
  /// Without the texture effect always the first.
  const Reflectance<T>& at(TextureUv<T> uv, bool texture_effect) const;

  /// All that it may be; the same twice where it is uniform.
  const Reflectance<T>& first() const { return first_; }
  const Reflectance<T>& second() const { return chequer_ ? second_ : first_; }

  /// Whether (u,v) matters at all.
  bool uniform() const { return !chequer_; }

 private:
  Reflectance<T> first_, second_;
  T cells_u_, cells_v_;
  bool chequer_;
  bool few_;                              // both numbers of cells are
  std::int32_t last_u_ = 0, last_v_ = 0;  // cells, then
};

}  // namespace sir
