// Filtered illumination rays (thesis 2.4.1, 2.4.3) by packets: what a light's rays
// pass on their way, in scenes that let light through.
#pragma once

#include "tracer/packet.h"
#include "tracer/packet_solid.h"

namespace sir {

/// Every active lane is in one of the masks. `doubtful`: the Classifier knows.
template <typename T>
struct PacketFilter {
  static constexpr std::size_t kMostParts = 3;
  static constexpr std::size_t kMostCrossed = 2 * kMostParts;

  std::uint32_t open = 0, crossing = 0, doubtful = 0;  ///< lanes
  struct Crossed {
    T t;                 ///< within (0,1)
    std::uint32_t leaf;  ///< as in Boundary
    std::uint8_t face;
  };
  /// Of the lanes in `crossing`: the boundaries, in order.
  Crossed crossed[kPacketLanes][kMostCrossed];
  std::uint8_t count[kPacketLanes];
  PacketCosts costs;
};

/// The boundaries that Classifier::begin() and next() find on each ray before its
/// light, which is at t = 1 (the packet's `farthest` is not asked).
///
/// Certain where the ray meets a few parts only, each a primitive by itself, one
/// behind the other with room between them, and the start, the light and all
/// boundaries lie apart by more than their errors and the reach of a chain of
/// boundaries that are one event. That is nearly always so.
///
/// The solid must have been built for Formulas::robust. T: float or double.
template <typename T>
PacketFilter<T> find_filters(const PacketSolid<T>& solid, const RayPacket<T>& rays);

}  // namespace sir
