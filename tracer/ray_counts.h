// What rays were cast (the costs of thesis 2.5).
#pragma once

#include <cstdint>

#include "tracer/cost_counts.h"

namespace sir {

/// Rays cast, by kind, and intersections found. All but `spans`, `packets` and `costs`
/// are the same however the rays are grouped (see CostCounts).
struct RayCounts {
  std::uint64_t primary = 0, reflected = 0, refracted = 0, shadow = 0;
  std::uint64_t filtered = 0;  ///< of the shadow rays, those that something dimmed
  std::uint64_t spared = 0;    ///< rays not cast, since they could not change a byte any more
  std::uint64_t spans = 0;     ///< primitives that those rays went through, as often as found
  std::uint64_t exact = 0;     ///< intersections that needed more digits than T has
  std::uint64_t packets = 0;   ///< in which rays were sent, up to 16 in each
  std::uint64_t doubtful = 0;  ///< rays that a packet left to be traced one by one
  CostCounts costs;            ///< of all those rays together

  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
    filtered += other.filtered;
    spared += other.spared;
    spans += other.spans;
    exact += other.exact;
    packets += other.packets;
    doubtful += other.doubtful;
    costs += other.costs;
    return *this;
  }
};

}  // namespace sir
