#include "tracer/wavefront.h"

#include "tracer/ray_secondary.h"
#include "tracer/ray_shadow.h"
#include "tracer/shade.h"

namespace sir {

template <typename T>
Wavefront<T>::Wavefront(const Model<T>& model, const TraceOptions& options)
    : model_(model),
      options_(options),
      packets_(model.solid, options.packets ? model.laid_out.get() : nullptr, options.engine),
      deep_(model, options),
      bound_(model, options) {}

template <typename T>
RayCounts Wavefront<T>::counts() const {
  RayCounts counts = counts_;
  counts += packets_.counts();
  counts += deep_.counts();
  return counts;
}

template <typename T>
void Wavefront<T>::pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes) {
  const std::size_t count = bytes.size();
  rays_.clear();
  nodes_.clear();
  ledgers_.resize(count);
  colours_.assign(count, model_.background);
  for (std::uint32_t p = 0; p < count; ++p) {
    ledgers_[p].open(!model_.effects.exhaustive && bound_.bounded());
    rays_.push_back({primary[p], {}, Colour<T>(0), T(0), T(1), kNone, p, false});
  }
  counts_.primary += count;
  for (int depth = 1; !rays_.empty(); ++depth) {
    if (depth > kBreadth) {
      finish_deep(depth);
      break;
    }
    const std::size_t first = nodes_.size();
    find_hits(depth);
    shade_nodes(first);
    next_.clear();
    branch(first, depth);
    rays_.swap(next_);
  }
  // Points stand behind the points that they are seen from.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    deliver(node.parent, node.pixel, node.mirror, node.own + node.mirrored + node.passed);
  }
  for (std::size_t p = 0; p < count; ++p) bytes[p] = to_rgb8(colours_[p]);
}

// Where the rays hit: a point for each, and what its secondary rays may bring.
template <typename T>
void Wavefront<T>::find_hits(int depth) {
  together_.clear();
  for (const Ray& ray : rays_) together_.push_back({ray.ray, ray.start});
  packets_.first(together_, std::numeric_limits<T>::infinity(), met_, boundaries_);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Ray& ray = rays_[i];
    PixelLedger<T>& ledger = ledgers_[ray.pixel];
    if (!met_[i]) {
      ledger.settle(ray.most, ray.path_weight * model_.background);
      deliver(ray.parent, ray.pixel, ray.mirror, model_.background);
      continue;
    }
    Node& node = nodes_.emplace_back();
    node.hit = hit_at(model_, ray.ray, boundaries_[i]);
    node.branching = branching_at(model_, node.hit, ray.index);
    node.path_weight = ray.path_weight;
    node.parent = ray.parent;
    node.pixel = ray.pixel;
    node.mirror = ray.mirror;
    const Reflectance<T>& k = *node.hit.reflectance;
    node.own = model_.ambient * k.ambient;
    Colour<T> most(0);
    for (const PointLight<T>& source : model_.lights) most += most_of(k, source);
    ledger.expect(most_of_branch(node, true, depth) + most_of_branch(node, false, depth) +
                      node.path_weight * most,
                  static_cast<T>(model_.lights.size() + 1));
    ledger.settle(ray.most, node.path_weight * node.own);
  }
}

template <typename T>
void Wavefront<T>::shade_nodes(std::size_t first) {
  for (const PointLight<T>& source : model_.lights) ask_light(first, source);
}

// See shade(): the same, light by light, for all points of a depth.
template <typename T>
void Wavefront<T>::ask_light(std::size_t first, const PointLight<T>& source) {
  const EffectSet& effects = model_.effects;
  asked_.clear();
  together_.clear();
  for (std::size_t n = first; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    PixelLedger<T>& ledger = ledgers_[node.pixel];
    const Incidence<T> incidence(node.hit, source);
    const Colour<T> most = most_of(*node.hit.reflectance, source);
    const bool lit = incidence.cosine > 0;
    const bool asked = effects.exhaustive ? incidence.distance > 0 : lit && most != Colour<T>(0);
    if (!asked) {
      ledger.settle(node.path_weight * most, Colour<T>(0));
    } else if (!effects.shadow) {
      light_up(node, incidence, source, source.intensity);
    } else if (ledger.decided()) {
      ++counts_.spared;
    } else {
      asked_.push_back({static_cast<std::uint32_t>(n), incidence});
      together_.push_back({{node.hit.point, incidence.to_light}, node.hit.leaving_on_eye_side()});
    }
  }
  counts_.shadow += asked_.size();
  find_arriving(source);
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const Colour<T>& arriving = arriving_[i];
    if (arriving != source.intensity && arriving != Colour<T>(0)) ++counts_.filtered;
    light_up(nodes_[asked_[i].node], asked_[i].incidence, source, arriving);
  }
}

// How much of the light comes along the rays that go together: light_reaching() of each.
template <typename T>
void Wavefront<T>::find_arriving(const PointLight<T>& source) {
  arriving_.assign(together_.size(), source.intensity);
  if (!model_.effects.filter) {
    packets_.blocked(together_, source.clearance, met_);
    for (std::size_t i = 0; i < together_.size(); ++i)
      if (met_[i]) arriving_[i] = Colour<T>(0);
    return;
  }
  // Most meet nothing, or something opaque: only glass needs the whole list.
  packets_.first(together_, T(1), met_, boundaries_);
  for (std::size_t i = 0; i < together_.size(); ++i) {
    if (!met_[i]) continue;
    const RayCena<T>& ray = together_[i].ray;
    const Boundary<T>& boundary = boundaries_[i];
    if (!(boundary.t < 1) || Numeric<T>::same_event(boundary.t, T(1))) continue;
    const bool glass = reflectance_at(model_, boundary, ray.at(boundary.t)).transmission > 0;
    arriving_[i] =
        glass ? light_through(model_, packets_.classifier(), ray, together_[i].start, source)
              : Colour<T>(0);
  }
}

template <typename T>
void Wavefront<T>::light_up(Node& node, const Incidence<T>& incidence, const PointLight<T>& source,
                            const Colour<T>& arriving) {
  Colour<T> came(0);
  if (incidence.cosine > 0 && arriving != Colour<T>(0)) {
    came = arriving * sent_back(model_.effects, node.hit, incidence);
    node.own += came;
  }
  ledgers_[node.pixel].settle(node.path_weight * most_of(*node.hit.reflectance, source),
                              node.path_weight * came);
}

template <typename T>
bool Wavefront<T>::wanted(const Node& node, T weight) const {
  if (!(weight > 0)) return model_.effects.exhaustive;
  return node.path_weight * weight >= static_cast<T>(options_.cutoff);
}

// The most that the pixel may get from the mirrored or the refracted ray.
template <typename T>
Colour<T> Wavefront<T>::most_of_branch(const Node& node, bool mirror, int depth) const {
  const T weight = mirror ? node.branching.mirror_weight : node.branching.through_weight;
  if (!(weight > 0)) return Colour<T>(0);
  if (depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::zero) return Colour<T>(0);
    return node.path_weight * weight * model_.background;
  }
  if (!wanted(node, weight)) return Colour<T>(0);
  return node.path_weight * weight * bound_.at(depth + 1);
}

template <typename T>
void Wavefront<T>::branch(std::size_t first, int depth) {
  for (std::size_t n = first; n < nodes_.size(); ++n)
    for (const bool mirror : {true, false})
      branch_off(static_cast<std::uint32_t>(n), mirror, depth);
}

template <typename T>
void Wavefront<T>::branch_off(std::uint32_t index, bool mirror, int depth) {
  Node& node = nodes_[index];
  const Branching<T>& branching = node.branching;
  const T weight = mirror ? branching.mirror_weight : branching.through_weight;
  PixelLedger<T>& ledger = ledgers_[node.pixel];
  if (depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::background && weight > 0)
      (mirror ? node.mirrored : node.passed) = weight * model_.background;
    const Colour<T> most = most_of_branch(node, mirror, depth);
    ledger.settle(most, most);
    return;
  }
  const bool allowed = mirror ? model_.effects.reflection || weight > 0 : branching.has_through;
  if (!allowed || !wanted(node, weight)) return;
  if (ledger.decided()) {
    ++counts_.spared;
    return;
  }
  ++(mirror ? counts_.reflected : counts_.refracted);
  next_.push_back(
      {{node.hit.point, mirror ? mirrored(node.hit.incident, node.hit.normal) : branching.through},
       mirror ? node.hit.leaving_on_eye_side() : node.hit.leaving_through(),
       most_of_branch(node, mirror, depth),
       mirror ? branching.index : branching.index_beyond,
       node.path_weight * weight,
       index,
       node.pixel,
       mirror});
}

// What lies deeper is followed ray by ray, in memory that does not grow.
template <typename T>
void Wavefront<T>::finish_deep(int depth) {
  for (const Ray& ray : rays_)
    deliver(ray.parent, ray.pixel, ray.mirror,
            deep_.radiance_of(ray.ray, ray.start, ray.index, ray.path_weight, depth));
}

// Hands what a ray saw to the point that sent it, or to the pixel.
template <typename T>
void Wavefront<T>::deliver(std::uint32_t parent, std::uint32_t pixel, bool mirror,
                           const Colour<T>& colour) {
  if (parent == kNone) {
    colours_[pixel] = colour;
    return;
  }
  Node& node = nodes_[parent];
  const T weight = mirror ? node.branching.mirror_weight : node.branching.through_weight;
  if (weight > 0) (mirror ? node.mirrored : node.passed) = weight * colour;
}

template class Wavefront<float>;
template class Wavefront<double>;
template class Wavefront<long double>;

}  // namespace sir
