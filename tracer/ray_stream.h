// Rays that go together, packet after packet.
#pragma once

#include <span>
#include <vector>

#include "tracer/packet.h"

namespace sir {

/// Any number of rays in packets; all of these are full but the last.
template <typename T>
class RayStream {
 public:
  std::size_t size() const { return size_; }
  std::size_t packets() const { return (size_ + kPacketLanes - 1) / kPacketLanes; }
  const RayPacket<T>& packet(std::size_t p) const { return packets_[p]; }
  std::span<const RayPacket<T>> all() const { return std::span(packets_).first(packets()); }

  void clear() { size_ = 0; }
  void push(const RayCena<T>& ray, const RayStart<T>& start = {},
            T reach = std::numeric_limits<T>::infinity()) {
    const std::size_t p = size_ / kPacketLanes, lane = size_ % kPacketLanes;
    if (p == packets_.size()) packets_.emplace_back();
    if (lane == 0) packets_[p].active = 0;
    packets_[p].set(lane, ray, start, reach);
    ++size_;
  }

 private:
  std::vector<RayPacket<T>> packets_;
  std::size_t size_ = 0;
};

}  // namespace sir
