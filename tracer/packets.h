// A packet's rays, and what packets leave in doubt by the Classifier (for
// RAY-TRACING, thesis 2.3.6).
#pragma once

#include "tracer/packet_filter.h"
#include "tracer/packet_first.h"
#include "tracer/ray_counts.h"

namespace sir {

/// Finds boundaries of sixteen rays at a time; one for each thread. T: float or double.
template <typename T>
class Packets {
 public:
  /// `laid_out` belongs to `solid`.
  Packets(const Solid<T>& solid, const PacketSolid<T>& laid_out)
      : laid_out_(laid_out), classifier_(solid) {}

  /// Fills the list for rays that are to go together; false where it is of no use.
  bool list(std::span<const RayPacket<T>> rays, PartList<T>& list);

  /// Classifier::first() of each ray; none stays doubtful. `list`: of these rays, or
  /// null.
  PacketFirst<T> first(const RayPacket<T>& rays, const PartList<T>* list = nullptr);

  /// The lanes that Classifier::blocked() is true for; lights are at t = 1.
  std::uint32_t blocked(const RayPacket<T>& rays, T clearance);

  /// What the rays of `where` pass on the way to their light; some may stay doubtful.
  PacketFilter<T> filters(const RayPacket<T>& rays, std::uint32_t where);

  /// For a ray of such a packet that is traced by the Classifier.
  void count_doubtful() { ++counts_.doubtful; }

  Classifier<T>& classifier() { return classifier_; }
  const Classifier<T>& classifier() const { return classifier_; }

  /// What was found and what that took, of packets and of the Classifier: `spans`,
  /// `exact`, `packets`, `doubtful` and `costs`.
  RayCounts counts() const;

 private:
  void add(const PacketCosts& costs, std::uint32_t doubtful);

  const PacketSolid<T>& laid_out_;
  Classifier<T> classifier_;
  RayCounts counts_;  // without the Classifier's own
};

}  // namespace sir
