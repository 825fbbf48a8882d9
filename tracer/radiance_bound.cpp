#include "tracer/radiance_bound.h"

namespace sir {
namespace {

// Rays that deep are not told apart: their bound is that of any depth.
constexpr int kDepthsTold = 64;

}  // namespace

template <typename T>
RadianceBound<T>::RadianceBound(const Model<T>& model, const TraceOptions& options)
    : depth_limit_(options.depth_limit) {
  Colour<T> light(0);
  for (const PointLight<T>& source : model.lights) light += source.intensity;
  // Each surface by itself: what it sends back of its own, and what it passes on.
  struct Sent {
    Colour<T> own;
    T passed_on;
  };
  std::vector<Sent> sent;
  T passed_on = 0;
  std::vector<bool> seen(model.textures.size());
  for (const Leaf<T>& leaf : model.solid.leaves)
    for (int face = 0; face < face_count(leaf.kind); ++face) {
      const std::uint32_t surface = leaf.surfaces[static_cast<std::size_t>(face)];
      if (seen[surface]) continue;
      seen[surface] = true;
      const Texture<T>& texture = model.textures[surface];
      for (const Reflectance<T>* k : {&texture.first(), &texture.second()}) {
        sent.push_back({model.ambient * k->ambient + light * (k->diffuse + k->specular),
                        k->specular + k->transmission});
        passed_on = std::max(passed_on, sent.back().passed_on);
        // What overflows has no bound, and times zero it is no number.
        const T sum = sent.back().own.r + sent.back().own.g + sent.back().own.b + passed_on;
        bounded_ = bounded_ && k->transmission <= 1 && std::isfinite(sum);
      }
    }

  // What is bounded rounds once for each light and a few times more, and so does
  // the bound.
  const T slack =
      1 + (64 + 16 * static_cast<T>(model.lights.size())) * std::numeric_limits<T>::epsilon();
  const auto rounded_up = [&](const Colour<T>& bound) { return bound * slack; };
  const auto next = [&](const Colour<T>& beyond) {
    Colour<T> most = model.background;
    for (const Sent& one : sent) most = glm::max(most, one.own + one.passed_on * beyond);
    return rounded_up(most);
  };
  const bool sees_background = options.past_limit == PastLimit::background;
  by_depth_left_.push_back(next(sees_background ? model.background : Colour<T>(0)));
  const int told = std::min(depth_limit_ - 1, kDepthsTold);
  for (int left = 1; left <= told; ++left) by_depth_left_.push_back(next(by_depth_left_.back()));
  if (depth_limit_ - 1 > told) {
    // No more than the bound that one more depth leaves as it is.
    Colour<T> all = model.background;
    for (const Sent& one : sent) all = glm::max(all, one.own);
    all = rounded_up(all / std::max(T(0), 1 - passed_on));
    by_depth_left_.push_back(passed_on < 1 ? glm::max(all, by_depth_left_.back())
                                           : Colour<T>(std::numeric_limits<T>::infinity()));
  }
}

template class RadianceBound<float>;
template class RadianceBound<double>;
template class RadianceBound<long double>;

}  // namespace sir
