// INTERSECTA (thesis 2.3.4) for a packet: one primitive, sixteen rays.
#pragma once

#include "tracer/packet.h"
#include "tracer/packet_solid.h"

namespace sir {

/// What Leaf::to_local() and intersect() say of each active lane, with t already in
/// units of the ray's own direction. Lanes in neither mask miss. Lanes in `unsure`
/// are for intersect_exactly(); among them are those on the way to whose SC_LOCAL
/// digits are lost to underflow.
template <typename T>
struct PacketSpans {
  alignas(64) T enter[kPacketLanes], leave[kPacketLanes];
  alignas(64) T enter_error[kPacketLanes], leave_error[kPacketLanes];
  std::uint8_t enter_face[kPacketLanes], leave_face[kPacketLanes];
  std::uint32_t crosses = 0, unsure = 0;  ///< lanes

  Span<T> span(std::size_t lane) const {
    return {enter[lane],       leave[lane],      enter_error[lane],
            leave_error[lane], enter_face[lane], leave_face[lane]};
  }
};

/// The whole lines, without regard to where the rays start. Bit for bit what the
/// scalar functions answer, but for the sign of a zero, on every processor. T: float
/// or double.
template <typename T>
PacketSpans<T> intersect_packet(const PacketLeaf<T>& leaf, const RayPacket<T>& rays);

}  // namespace sir
