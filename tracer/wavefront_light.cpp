// The lights of a wavefront's points: shade() for all points of a depth, light by light.
#include "tracer/ray_shadow.h"
#include "tracer/shade.h"
#include "tracer/wavefront.h"

namespace sir {

template <typename T>
void Wavefront<T>::ask_light(const PointLight<T>& source, int depth) {
  asked_.clear();
  shadow_.clear();
  PacketIncidence<T> incidence;
  std::size_t last = hits_.size();
  for_each_hit([&](std::uint32_t node, std::size_t p, std::size_t lane) {
    if (p != last)
      find_incidence(hits_[p], hit_lanes_[p], source.position, model_.effects.highlight, incidence);
    last = p;
    ask(node, source, hits_[p], incidence, lane, depth);
  });
  counts_.shadow += asked_.size();
  hear_light(source);
}

template <typename T>
void Wavefront<T>::ask(std::uint32_t node, const PointLight<T>& source, const PacketHits<T>& hits,
                       const PacketIncidence<T>& incidence, std::size_t lane, int depth) {
  const EffectSet& effects = model_.effects;
  const Detail& detail = this->detail(node);
  const Colour<T> most = most_of(*detail.reflectance, source);
  const T cosine = incidence.cosine[lane];
  const bool asked =
      effects.exhaustive ? incidence.distance[lane] > 0 : cosine > 0 && most != Colour<T>(0);
  if (!asked) return;
  const Asked question{node, cosine, effects.highlight ? incidence.gleam[lane] : T(-1)};
  if (!effects.shadow) {
    light_up(question, source.intensity);
  } else if (sparing_ && spares(node, detail.path_weight * most, &source, depth)) {
    ++counts_.spared;
  } else {
    asked_.push_back(question);
    shadow_.push({hits.point_of(lane), incidence.to_light_of(lane)},
                 leaving(node, hits.error[lane], false), T(1));
  }
}

// What comes along the shadow rays: light_reaching() of each.
template <typename T>
void Wavefront<T>::hear_light(const PointLight<T>& source) {
  for (std::size_t p = 0; p < shadow_.packets(); ++p) {
    const RayPacket<T>& rays = shadow_.packet(p);
    Colour<T> arriving[kPacketLanes];
    if (model_.effects.filter) {
      hear_through_glass(rays, source, arriving);
    } else {
      // Blocked by anything is told sooner than by what first; but not of a light among
      // the envelopes, where nothing is certain that way.
      const std::uint32_t blocked =
          source.clearance > 0 ? packets_.blocked(rays, source.clearance) : met_before_light(rays);
      for (std::size_t lane = 0; lane < kPacketLanes; ++lane)
        arriving[lane] = blocked >> lane & 1u ? Colour<T>(0) : source.intensity;
    }
    const std::size_t first = kPacketLanes * p;
    for (std::size_t lane = 0; lane < kPacketLanes && first + lane < asked_.size(); ++lane) {
      if (arriving[lane] != source.intensity && arriving[lane] != Colour<T>(0)) ++counts_.filtered;
      light_up(asked_[first + lane], arriving[lane]);
    }
  }
}

template <typename T>
std::uint32_t Wavefront<T>::met_before_light(const RayPacket<T>& rays) {
  const PacketFirst<T> found = packets_.first(rays);
  std::uint32_t met = 0;
  for (std::uint32_t left = found.hit; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const T t = found.boundary[lane].t;
    if (t < 1 && !Numeric<T>::same_event(t, T(1))) met |= 1u << lane;
  }
  return met;
}

// Where all parts are primitives, what the rays pass is soon found. Else, and where that
// stays in doubt: most rays meet nothing, or something opaque, and only glass needs all
// boundaries.
template <typename T>
void Wavefront<T>::hear_through_glass(const RayPacket<T>& rays, const PointLight<T>& source,
                                      Colour<T> (&arriving)[kPacketLanes]) {
  std::fill_n(arriving, kPacketLanes, source.intensity);
  std::uint32_t left = rays.active;
  if (model_.laid_out->all_alone) left = hear_filters(rays, left, source, arriving);
  if (left == 0) return;
  RayPacket<T> asked = rays;
  asked.active = left;
  const PacketFirst<T> found = packets_.first(asked);
  std::uint32_t glass = 0;
  for (std::uint32_t hit = found.hit; hit != 0; hit &= hit - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(hit));
    const Boundary<T>& boundary = found.boundary[lane];
    if (!(boundary.t < 1) || Numeric<T>::same_event(boundary.t, T(1))) continue;
    if (transmission_at(rays, lane, boundary.leaf, boundary.face, boundary.t) > 0)
      glass |= 1u << lane;
    else arriving[lane] = Colour<T>(0);
  }
  if (glass != 0 && !model_.laid_out->all_alone)
    glass = hear_filters(rays, glass, source, arriving);
  for (; glass != 0; glass &= glass - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(glass));
    packets_.count_doubtful();
    arriving[lane] =
        light_through(model_, packets_.classifier(), rays.ray(lane), rays.start(lane), source);
  }
}

// The lanes of `where` that stay in doubt.
template <typename T>
std::uint32_t Wavefront<T>::hear_filters(const RayPacket<T>& rays, std::uint32_t where,
                                         const PointLight<T>& source,
                                         Colour<T> (&arriving)[kPacketLanes]) {
  const PacketFilter<T> filters = packets_.filters(rays, where);
  for (std::uint32_t left = filters.crossing; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    T passed = 1;
    for (std::size_t b = 0; b < filters.count[lane] && passed > 0; ++b) {
      const auto& crossed = filters.crossed[lane][b];
      const T kt = transmission_at(rays, lane, crossed.leaf, crossed.face, crossed.t);
      passed = kt > 0 ? passed * kt : T(0);
    }
    arriving[lane] = source.intensity * passed;
  }
  return filters.doubtful;
}

template <typename T>
T Wavefront<T>::transmission_at(const RayPacket<T>& rays, std::size_t lane, std::uint32_t leaf,
                                std::uint8_t face, T t) const {
  const auto local = [&] {
    return model_.solid.leaves[leaf].placement.unapply(rays.ray(lane).at(t));
  };
  return reflectance_on(model_, leaf, face, local).transmission;
}

template <typename T>
void Wavefront<T>::light_up(const Asked& asked, const Colour<T>& arriving) {
  Node& node = nodes_[asked.node];
  const Detail& detail = this->detail(asked.node);
  if (!(asked.cosine > 0) || arriving == Colour<T>(0)) return;
  const Colour<T> came =
      arriving * sent_back(model_.effects, *detail.reflectance, asked.cosine, asked.gleam);
  node.own += came;
  come_to(node.pixel, detail.path_weight * came);
}

template void Wavefront<float>::ask_light(const PointLight<float>&, int);
template void Wavefront<double>::ask_light(const PointLight<double>&, int);

}  // namespace sir
