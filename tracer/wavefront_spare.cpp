// Rays of a wavefront that cannot change a byte: the rule of PixelLedger without its
// books. A pixel's points of one depth lie side by side, so what it still awaits is
// summed up only where a ray brings less than a level by itself, which is rare.
#include "tracer/pixel_ledger.h"
#include "tracer/wavefront.h"

namespace sir {

template <typename T>
void Wavefront<T>::come_to(std::uint32_t pixel, const Colour<T>& colour) {
  if (sparing_) come_[pixel] += colour;
}

// Whether a ray of the node that brings at most `most` need not be cast, since the
// pixel's bytes are known without what it still awaits. `from`: the light that it
// goes to, or null where all lights of this depth were heard.
template <typename T>
bool Wavefront<T>::spares(std::uint32_t node, const Colour<T>& most, const PointLight<T>* from,
                          int depth) {
  return !level_to_come(come_[nodes_[node].pixel], most) && decided(node, from, depth);
}

template <typename T>
bool Wavefront<T>::decided(std::uint32_t node, const PointLight<T>* from, int depth) {
  const std::uint32_t pixel = nodes_[node].pixel;
  const auto of_pixel = [&](std::uint32_t n) { return nodes_[n].pixel == pixel; };
  std::uint32_t first = node, end = node + 1;
  while (first > first_ && of_pixel(first - 1)) --first;
  while (end < nodes_.size() && of_pixel(end)) ++end;
  const Colour<T> rest =
      from ? lights_from_[static_cast<std::size_t>(from - model_.lights.data())] : Colour<T>(0);
  Colour<T> awaited(0);
  for (std::uint32_t n = first; n < end; ++n) {
    const Reflectance<T>& k = *detail(n).reflectance;
    awaited += detail(n).path_weight * (rest * (k.diffuse + k.specular));
    awaited += most_of_branch(n, true, depth) + most_of_branch(n, false, depth);
    if (level_to_come(come_[pixel], awaited)) return false;
  }
  return bytes_are_known(come_[pixel], awaited, slack(depth));
}

// Roundings of all sums that lie between the pixel's intensity as it will be added up
// and what is known here: of the terms that came, and of those on the way up the tree.
// No sum is larger than what a primary ray can bring.
template <typename T>
T Wavefront<T>::slack(int depth) const {
  const auto lights = static_cast<T>(model_.lights.size());
  const T come = std::ldexp(lights + 3, std::min(depth, kBreadth));
  const T on_the_way = static_cast<T>(options_.depth_limit) * (lights + 8);
  const Colour<T>& most = bound_.at(1);
  return 8 * (come + on_the_way) * std::numeric_limits<T>::epsilon() *
         std::max({most.r, most.g, most.b});
}

template <typename T>
bool Wavefront<T>::wanted(std::uint32_t node, T weight) const {
  if (!(weight > 0)) return model_.effects.exhaustive;
  return detail(node).path_weight * weight >= static_cast<T>(options_.cutoff);
}

// The most that the pixel may get from the mirrored or the refracted ray.
template <typename T>
Colour<T> Wavefront<T>::most_of_branch(std::uint32_t node, bool mirror, int depth) const {
  const T weight = mirror ? nodes_[node].mirror_weight : nodes_[node].through_weight;
  if (!(weight > 0)) return Colour<T>(0);
  const T path_weight = detail(node).path_weight;
  if (depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::zero) return Colour<T>(0);
    return path_weight * weight * model_.background;
  }
  if (!wanted(node, weight)) return Colour<T>(0);
  return path_weight * weight * bound_.at(depth + 1);
}

#define SIR_INSTANTIATE(T)                                                                        \
  template void Wavefront<T>::come_to(std::uint32_t, const Colour<T>&);                           \
  template bool Wavefront<T>::spares(std::uint32_t, const Colour<T>&, const PointLight<T>*, int); \
  template Colour<T> Wavefront<T>::most_of_branch(std::uint32_t, bool, int) const;                \
  template bool Wavefront<T>::wanted(std::uint32_t, T) const;
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
#undef SIR_INSTANTIATE

}  // namespace sir
