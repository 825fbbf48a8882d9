// Sixteen rays at once (packets: Wald, Slusallek, Benthin, Wagner, Interactive
// Rendering with Coherent Ray Tracing, 2001), each with the start and the reach of
// its own. What is found for them is bit for bit what the Classifier finds.
#pragma once

#include <cstdint>
#include <limits>

#include "tracer/classify.h"

namespace sir {

/// Rays of a packet, whatever the processor's vectors hold.
inline constexpr std::size_t kPacketLanes = 16;

/// What a packet took, over its rays (see CostCounts).
struct PacketCosts {
  CostCounts counts;        ///< calls without those of the primitives
  std::uint64_t spans = 0;  ///< primitives that were met, ray by ray
};

/// Rays in SC_CENA, component by component: component[axis][lane]. Lanes whose
/// bit in `active` is 0 are not looked at.
template <typename T>
struct RayPacket {
  alignas(64) T origin[3][kPacketLanes] = {};
  alignas(64) T direction[3][kPacketLanes] = {};
  alignas(64) T farthest[kPacketLanes] = {};     ///< what lies beyond may be missing
  alignas(64) T start_error[kPacketLanes] = {};  ///< as RayStart::error
  std::uint32_t start_leaf[kPacketLanes] = {};   ///< RayStart<T>::kNowhere: a free ray
  std::uint32_t inward = 0;                      ///< lanes: as RayStart::inward
  std::uint32_t active = 0;                      ///< lanes

  void set(std::size_t lane, const RayCena<T>& ray, const RayStart<T>& start = {},
           T reach = std::numeric_limits<T>::infinity()) {
    const std::uint32_t bit = 1u << lane;
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis][lane] = ray.origin.v[axis];
      direction[axis][lane] = ray.direction.v[axis];
    }
    farthest[lane] = reach;
    start_error[lane] = start.error;
    start_leaf[lane] = start.leaf;
    inward = start.inward ? inward | bit : inward & ~bit;
    active |= bit;
  }

  RayCena<T> ray(std::size_t lane) const {
    return {{{origin[0][lane], origin[1][lane], origin[2][lane]}},
            {{direction[0][lane], direction[1][lane], direction[2][lane]}}};
  }

  RayStart<T> start(std::size_t lane) const {
    return {start_leaf[lane], (inward >> lane & 1u) != 0, start_error[lane]};
  }
};

}  // namespace sir
