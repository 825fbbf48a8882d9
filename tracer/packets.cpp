#include "tracer/packets.h"

#include "tracer/packet_blocked.h"

namespace sir {
namespace {

template <typename T>
inline constexpr bool kInPackets = !std::is_same_v<T, long double>;

}  // namespace

template <typename T>
Packets<T>::Packets(const Solid<T>& solid, const PacketSolid<T>* laid_out, Engine engine)
    : laid_out_(engine == Engine::gates ? laid_out : nullptr), classifier_(solid, engine) {}

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
void Packets<T>::add(const PacketCosts& costs) {
  ++counts_.packets;
  counts_.spans += costs.spans;
  counts_.costs += costs.counts;
}

template <typename T>
void Packets<T>::first(std::span<const StartedRay<T>> rays, T farthest, std::vector<char>& met,
                       std::vector<Boundary<T>>& boundaries) {
  met.resize(rays.size());
  boundaries.resize(rays.size());
  const auto ask = [&](std::size_t i) {
    met[i] = classifier_.first(rays[i].ray, rays[i].start, boundaries[i], farthest);
    counts_.spans += classifier_.spans();
  };
  std::size_t i = 0;
  if constexpr (kInPackets<T>) {
    while (laid_out_ && i < rays.size()) {
      RayPacket<T> packet;
      const std::size_t lanes = std::min(kPacketLanes, rays.size() - i);
      for (std::size_t lane = 0; lane < lanes; ++lane)
        packet.set(lane, rays[i + lane].ray, rays[i + lane].start, farthest);
      const PacketFirst<T> found = first_boundaries(*laid_out_, packet);
      add(found.costs);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (found.doubtful >> lane & 1u) {
          ++counts_.doubtful;
          ask(i + lane);
          continue;
        }
        met[i + lane] = found.hit >> lane & 1u;
        boundaries[i + lane] = found.boundary[lane];
      }
      i += lanes;
    }
  }
  for (; i < rays.size(); ++i) ask(i);
}

template <typename T>
void Packets<T>::blocked(std::span<const StartedRay<T>> rays, T clearance,
                         std::vector<char>& answer) {
  answer.resize(rays.size());
  const auto ask = [&](std::size_t i) {
    answer[i] = classifier_.blocked(rays[i].ray, rays[i].start, clearance);
    counts_.spans += classifier_.spans();
  };
  std::size_t i = 0;
  if constexpr (kInPackets<T>) {
    while (laid_out_ && i < rays.size()) {
      RayPacket<T> packet;
      const std::size_t lanes = std::min(kPacketLanes, rays.size() - i);
      for (std::size_t lane = 0; lane < lanes; ++lane)
        packet.set(lane, rays[i + lane].ray, rays[i + lane].start, T(1));
      const PacketBlocked found = find_blocked(*laid_out_, packet, clearance);
      add(found.costs);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (found.doubtful >> lane & 1u) {
          ++counts_.doubtful;
          ask(i + lane);
        } else {
          answer[i + lane] = found.blocked >> lane & 1u;
        }
      }
      i += lanes;
    }
  }
  for (; i < rays.size(); ++i) ask(i);
}

template class Packets<float>;
template class Packets<double>;
template class Packets<long double>;

}  // namespace sir
