// What rays were cast (the costs of thesis 2.5).
#pragma once

#include <array>
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
    for (const auto member : kMembers) this->*member += other.*member;
    costs += other.costs;
    return *this;
  }

  /// What has come since `before`.
  RayCounts since(const RayCounts& before) const {
    RayCounts result;
    for (const auto member : kMembers) result.*member = this->*member - before.*member;
    result.costs = costs.since(before.costs);
    return result;
  }

  friend bool operator==(const RayCounts&, const RayCounts&) = default;

  /// All that is counted here, but for `costs`.
  static const std::array<std::uint64_t RayCounts::*, 10> kMembers;
};

inline constexpr std::array<std::uint64_t RayCounts::*, 10> RayCounts::kMembers = {
    &RayCounts::primary,  &RayCounts::reflected, &RayCounts::refracted, &RayCounts::shadow,
    &RayCounts::filtered, &RayCounts::spared,    &RayCounts::spans,     &RayCounts::exact,
    &RayCounts::packets,  &RayCounts::doubtful};

}  // namespace sir
