// Illumination rays (thesis 2.4.1) by packets, in scenes that let no light through.
#pragma once

#include "tracer/packet.h"
#include "tracer/packet_solid.h"

namespace sir {

/// Every active lane is in one of the masks. `doubtful`: the Classifier knows.
struct PacketBlocked {
  std::uint32_t blocked = 0, open = 0, doubtful = 0;  ///< lanes
  PacketCosts costs;
};

/// What Classifier::blocked() says of each ray, whose light is at t = 1 (the
/// packet's `farthest` is not asked). `clearance`: how far the light is at least
/// from every primitive that adds to the solid, along some axis of SC_CENA. A lane
/// stays doubtful where that is too little (see classify_blocked.cpp).
///
/// A part of which some point on the way is surely inside, in a stretch too long
/// for boundaries that are one event, blocks; the first that does is enough. A ray
/// is open where all parts are surely absent.
///
/// The solid must have been built for Formulas::robust. T: float or double.
template <typename T>
PacketBlocked find_blocked(const PacketSolid<T>& solid, const RayPacket<T>& rays, T clearance);

}  // namespace sir
