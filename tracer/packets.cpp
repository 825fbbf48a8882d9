#include "tracer/packets.h"

#include <bit>

#include "tracer/packet_blocked.h"

namespace sir {

template <typename T>
PacketFirst<T> Packets<T>::first(const RayPacket<T>& rays, const PartList<T>* list) {
  PacketFirst<T> found = first_boundaries(laid_out_, rays, list);
  for (; found.doubtful != 0; found.doubtful &= found.doubtful - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(found.doubtful));
    const bool met = classifier_.first(rays.ray(lane), rays.start(lane), found.boundary[lane],
                                       rays.farthest[lane]);
    (met ? found.hit : found.missed) |= 1u << lane;
    spans_ += classifier_.spans();
    ++doubtful_;
  }
  return found;
}

template <typename T>
std::uint32_t Packets<T>::blocked(const RayPacket<T>& rays, T clearance) {
  PacketBlocked found = find_blocked(laid_out_, rays, clearance);
  for (; found.doubtful != 0; found.doubtful &= found.doubtful - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(found.doubtful));
    if (classifier_.blocked(rays.ray(lane), rays.start(lane), clearance))
      found.blocked |= 1u << lane;
    spans_ += classifier_.spans();
    ++doubtful_;
  }
  return found.blocked;
}

template <typename T>
PacketFilter<T> Packets<T>::filters(const RayPacket<T>& rays, std::uint32_t where) {
  RayPacket<T> asked = rays;
  asked.active = where;
  PacketFilter<T> found = find_filters(laid_out_, asked);
  doubtful_ += static_cast<std::uint64_t>(std::popcount(found.doubtful));
  return found;
}

template class Packets<float>;
template class Packets<double>;

}  // namespace sir
