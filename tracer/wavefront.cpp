#include "tracer/wavefront.h"

#include "tracer/branching.h"
#include "tracer/shade.h"

namespace sir {
template <typename T>
Wavefront<T>::Wavefront(const Model<T>& model, const TraceOptions& options)
    : model_(model),
      options_(options),
      packets_(model.solid, *model.laid_out),
      deep_(model, options),
      bound_(model, options),
      sparing_(!model.effects.exhaustive && bound_.bounded()),
      lights_from_(model.lights.size()) {
  Colour<T> sum(0);
  for (std::size_t light = model.lights.size(); light-- > 0;)
    lights_from_[light] = sum += model.lights[light].intensity;
}

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
  senders_.clear();
  nodes_.clear();
  if (sparing_) come_.assign(count, Colour<T>(0));
  colours_.assign(count, model_.background);
  for (std::uint32_t p = 0; p < count; ++p) {
    rays_.push(primary[p]);
    senders_.push_back({T(0), T(1), kNone, p, false});
  }
  counts_.primary += count;
  for (int depth = 1; rays_.size() > 0; ++depth) {
    if (depth > kBreadth) {
      finish_deep(depth);
      break;
    }
    find_points(depth);
    for (const PointLight<T>& source : model_.lights) ask_light(source, depth);
    next_.clear();
    next_senders_.clear();
    branch(depth);
    std::swap(rays_, next_);
    senders_.swap(next_senders_);
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
void Wavefront<T>::find_points(int depth) {
  first_ = static_cast<std::uint32_t>(nodes_.size());
  details_.clear();
  hits_.resize(std::max(hits_.size(), rays_.packets()));
  through_.resize(hits_.size());
  hit_lanes_.clear();
  const bool listed = depth == 1 && packets_.list(rays_.all(), list_);
  for (std::size_t p = 0; p < rays_.packets(); ++p) {
    const RayPacket<T>& rays = rays_.packet(p);
    const PacketFirst<T> found = packets_.first(rays, listed ? &list_ : nullptr);
    hit_lanes_.push_back(found.hit);
    for (std::uint32_t left = found.missed; left != 0; left &= left - 1)
      miss(senders_[kPacketLanes * p + static_cast<std::size_t>(std::countr_zero(left))]);
    if (found.hit == 0) continue;
    find_hits(model_, rays, found.hit, found.boundary, hits_[p]);
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    if (const std::uint32_t asking = add_nodes(p, found); asking != 0) refract(p, asking, node);
  }
}

template <typename T>
void Wavefront<T>::miss(const Sender& sender) {
  come_to(sender.pixel, sender.path_weight * model_.background);
  deliver(sender.parent, sender.pixel, sender.mirror, model_.background);
}

// A node for each hit of a packet; the lanes that ask for a refracted direction.
template <typename T>
std::uint32_t Wavefront<T>::add_nodes(std::size_t p, const PacketFirst<T>& found) {
  std::uint32_t asking = 0;
  for (std::uint32_t left = found.hit; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const Sender& sender = senders_[kPacketLanes * p + lane];
    const Boundary<T>& boundary = found.boundary[lane];
    const Reflectance<T>& k = reflectance_on(model_, boundary.leaf, boundary.face,
                                             [&] { return hits_[p].local_of(lane); });
    bool asks = false;
    const auto made =
        branching_before_refraction(model_.effects, k, boundary.entering, sender.index, asks);
    if (asks) asking |= 1u << lane;
    nodes_.push_back({model_.ambient * k.ambient, Colour<T>(0), Colour<T>(0), made.mirror_weight,
                      made.through_weight, sender.parent, sender.pixel, sender.mirror});
    details_.push_back({&k, sender.path_weight, made.index, made.index_beyond, boundary.leaf,
                        boundary.leaf_entering, false});
    come_to(sender.pixel, sender.path_weight * nodes_.back().own);
  }
  return asking;
}

template <typename T>
void Wavefront<T>::refract(std::size_t p, std::uint32_t asking, std::uint32_t node) {
  alignas(64) T from[kPacketLanes] = {}, to[kPacketLanes] = {};
  std::uint32_t at = node;
  for (std::uint32_t left = hit_lanes_[p]; left != 0; left &= left - 1, ++at) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    from[lane] = refraction_index(detail(at).index);
    to[lane] = detail(at).index_beyond;
  }
  const std::uint32_t bent = find_refracted(hits_[p], asking, from, to, through_[p].component);
  at = node;
  for (std::uint32_t left = hit_lanes_[p]; left != 0; left &= left - 1, ++at) {
    const std::uint32_t bit = left & -left;
    if (!(asking & bit)) continue;
    details_[at - first_].has_through = (bent & bit) != 0;
    if (bent & bit) continue;
    nodes_[at].mirror_weight += nodes_[at].through_weight;
    nodes_[at].through_weight = 0;
  }
}

template <typename T>
void Wavefront<T>::branch(int depth) {
  const EffectSet& effects = model_.effects;
  if (!effects.reflection && !effects.refraction) return;
  Directions mirrored;
  std::size_t last = hits_.size();
  for_each_hit([&](std::uint32_t node, std::size_t p, std::size_t lane) {
    if (p != last && depth < options_.depth_limit)
      find_mirrored(hits_[p], hit_lanes_[p], mirrored.component);
    last = p;
    const Node& from = nodes_[node];
    const PointCena<T> point = hits_[p].point_of(lane);
    if (from.mirror_weight > 0 || effects.exhaustive)
      branch_off(node, true, depth, {point, mirrored.of(lane)}, hits_[p].error[lane]);
    if (from.through_weight > 0 || effects.exhaustive)
      branch_off(node, false, depth, {point, through_[p].of(lane)}, hits_[p].error[lane]);
  });
}

template <typename T>
void Wavefront<T>::branch_off(std::uint32_t index, bool mirror, int depth, const RayCena<T>& ray,
                              T error) {
  Node& node = nodes_[index];
  const Detail& detail = this->detail(index);
  const T weight = mirror ? node.mirror_weight : node.through_weight;
  if (depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::background && weight > 0)
      (mirror ? node.mirrored : node.passed) = weight * model_.background;
    return;
  }
  const bool allowed = mirror ? model_.effects.reflection || weight > 0 : detail.has_through;
  if (!allowed || !wanted(index, weight)) return;
  if (sparing_ && spares(index, most_of_branch(index, mirror, depth), nullptr, depth)) {
    ++counts_.spared;
    return;
  }
  ++(mirror ? counts_.reflected : counts_.refracted);
  next_.push(ray, leaving(index, error, !mirror));
  next_senders_.push_back({mirror ? detail.index : detail.index_beyond, detail.path_weight * weight,
                           index, node.pixel, mirror});
}

// What lies deeper is followed ray by ray, in memory that does not grow.
template <typename T>
void Wavefront<T>::finish_deep(int depth) {
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const Sender& sender = senders_[r];
    const RayPacket<T>& rays = rays_.packet(r / kPacketLanes);
    const std::size_t lane = r % kPacketLanes;
    deliver(sender.parent, sender.pixel, sender.mirror,
            deep_.radiance_of(rays.ray(lane), rays.start(lane), sender.index, sender.path_weight,
                              depth));
  }
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
  const T weight = mirror ? node.mirror_weight : node.through_weight;
  if (weight > 0) (mirror ? node.mirrored : node.passed) = weight * colour;
}

template class Wavefront<float>;
template class Wavefront<double>;

}  // namespace sir
