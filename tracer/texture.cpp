#include "tracer/texture.h"

namespace sir {
namespace {

template <typename T>
Reflectance<T> converted(const Coefficients& k) {
  return {Colour<T>(k.ambient),       Colour<T>(k.diffuse),           static_cast<T>(k.specular),
          static_cast<T>(k.exponent), static_cast<T>(k.transmission), static_cast<T>(k.index)};
}

// So many cells are counted without rounding, in any T.
constexpr std::int64_t kFew = 1 << 20;

}  // namespace

template <typename T>
Texture<T>::Texture(const Surface& surface)
    : first_(converted<T>(surface.first)),
      second_(converted<T>(surface.second)),
      cells_u_(static_cast<T>(surface.cells_u)),
      cells_v_(static_cast<T>(surface.cells_v)),
      chequer_(surface.texture == TextureKind::chequer),
      few_(std::max(surface.cells_u, surface.cells_v) <= kFew) {
  if (!few_) return;
  last_u_ = static_cast<std::int32_t>(surface.cells_u) - 1;
  last_v_ = static_cast<std::int32_t>(surface.cells_v) - 1;
}

template <typename T>
const Reflectance<T>& Texture<T>::at(TextureUv<T> uv, bool texture_effect) const {
  if (!chequer_ || !texture_effect) return first_;
  if (few_) {
    const auto u = std::min(static_cast<std::int32_t>(uv.u * cells_u_), last_u_);
    const auto v = std::min(static_cast<std::int32_t>(uv.v * cells_v_), last_v_);
    return (u + v) % 2 == 0 ? first_ : second_;
  }
  const T cell = std::min(std::floor(uv.u * cells_u_), cells_u_ - 1) +
                 std::min(std::floor(uv.v * cells_v_), cells_v_ - 1);
  return std::fmod(cell, T(2)) == 0 ? first_ : second_;
}

template class Texture<float>;
template class Texture<double>;
template class Texture<long double>;

}  // namespace sir
