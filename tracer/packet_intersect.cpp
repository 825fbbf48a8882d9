#include "tracer/packet_intersect.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/packet_intersect.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "tracer/packet_kinds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

template <typename T>
void intersect_chunks(const PacketLeaf<T>& leaf, const RayPacket<T>& packet,
                      PacketSpans<T>& found) {
  RayPacket<T> free = packet;
  std::fill_n(free.start_leaf, kPacketLanes, RayStart<T>::kNowhere);
  const ReadyPacket<T> rays(free, nullptr);
  found.unsure = rays.wild;
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::Lanes(Chunk<T>())) {
    Spans<T> spans;
    cross(leaf, rays, lane, truths_of<T>(rays.tame >> lane), spans);
    found.unsure |= spans.unsure.bits() << lane;
    if (!spans.crosses.any()) continue;
    found.crosses |= spans.crosses.bits() << lane;
    spans.enter.store(found.enter + lane);
    spans.leave.store(found.leave + lane);
    spans.enter_error.store(found.enter_error + lane);
    spans.leave_error.store(found.leave_error + lane);
    alignas(64) typename Codes<T>::Word enter_face[kPacketLanes], leave_face[kPacketLanes];
    spans.enter_face.store(enter_face);
    spans.leave_face.store(leave_face);
    for (std::size_t i = 0; i < hn::Lanes(Chunk<T>()); ++i) {
      found.enter_face[lane + i] = static_cast<std::uint8_t>(enter_face[i]);
      found.leave_face[lane + i] = static_cast<std::uint8_t>(leave_face[i]);
    }
  }
}

void intersect_floats(const PacketLeaf<float>& leaf, const RayPacket<float>& rays,
                      PacketSpans<float>& found) {
  intersect_chunks(leaf, rays, found);
}
void intersect_doubles(const PacketLeaf<double>& leaf, const RayPacket<double>& rays,
                       PacketSpans<double>& found) {
  intersect_chunks(leaf, rays, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tracer/packet_target.h"

namespace sir {

template <>
PacketSpans<float> intersect_packet(const PacketLeaf<float>& leaf, const RayPacket<float>& rays) {
  PacketSpans<float> found;
  SIR_DISPATCH(intersect_floats)(leaf, rays, found);
  return found;
}

template <>
PacketSpans<double> intersect_packet(const PacketLeaf<double>& leaf,
                                     const RayPacket<double>& rays) {
  PacketSpans<double> found;
  SIR_DISPATCH(intersect_doubles)(leaf, rays, found);
  return found;
}

}  // namespace sir
#endif
