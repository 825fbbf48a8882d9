#include "tracer/packets.h"

#include <bit>

#include "tracer/packet_blocked.h"

namespace sir {

template <typename T>
RayCounts Packets<T>::counts() const {
  RayCounts counts = counts_;
  counts.exact = classifier_.exact_intersections();
  // A primitive is gone into as a node is.
  counts.costs.calls += counts.costs.transformations();
  counts.costs += classifier_.costs();
  return counts;
}

template <typename T>
void Packets<T>::add(const PacketCosts& costs, std::uint32_t doubtful) {
  ++counts_.packets;
  counts_.doubtful += static_cast<std::uint64_t>(std::popcount(doubtful));
  counts_.spans += costs.spans;
  counts_.costs += costs.counts;
}

template <typename T>
bool Packets<T>::list(std::span<const RayPacket<T>> rays, PartList<T>& list) {
  const bool listed = list.gather(laid_out_, rays);
  counts_.costs.envelopes += list.envelopes();
  return listed;
}

template <typename T>
PacketFirst<T> Packets<T>::first(const RayPacket<T>& rays, const PartList<T>* list) {
  PacketFirst<T> found = first_boundaries(laid_out_, rays, list);
  add(found.costs, found.doubtful);
  for (; found.doubtful != 0; found.doubtful &= found.doubtful - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(found.doubtful));
    const bool met = classifier_.first(rays.ray(lane), rays.start(lane), found.boundary[lane],
                                       rays.farthest[lane]);
    (met ? found.hit : found.missed) |= 1u << lane;
    counts_.spans += classifier_.spans();
  }
  return found;
}

template <typename T>
std::uint32_t Packets<T>::blocked(const RayPacket<T>& rays, T clearance) {
  PacketBlocked found = find_blocked(laid_out_, rays, clearance);
  add(found.costs, found.doubtful);
  for (; found.doubtful != 0; found.doubtful &= found.doubtful - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(found.doubtful));
    if (classifier_.blocked(rays.ray(lane), rays.start(lane), clearance))
      found.blocked |= 1u << lane;
    counts_.spans += classifier_.spans();
  }
  return found.blocked;
}

template <typename T>
PacketFilter<T> Packets<T>::filters(const RayPacket<T>& rays, std::uint32_t where) {
  RayPacket<T> asked = rays;
  asked.active = where;
  PacketFilter<T> found = find_filters(laid_out_, asked);
  add(found.costs, 0);
  return found;
}

template class Packets<float>;
template class Packets<double>;

}  // namespace sir
