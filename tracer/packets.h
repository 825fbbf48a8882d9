// Rays by the packet, and what packets leave in doubt by the Classifier (for
// RAY-TRACING, thesis 2.3.6).
#pragma once

#include <span>
#include <vector>

#include "tracer/classify.h"
#include "tracer/packet_first.h"
#include "tracer/ray_counts.h"

namespace sir {

/// A ray of its own start.
template <typename T>
struct StartedRay {
  RayCena<T> ray;
  RayStart<T> start;
};

/// Finds boundaries of many rays; one for each thread. Where the solid cannot be
/// laid out for packets, or T is long double, every ray goes to the Classifier.
template <typename T>
class Packets {
 public:
  /// `laid_out` may be null; else it belongs to `solid`. Packets do the work of
  /// Engine::gates only.
  Packets(const Solid<T>& solid, const PacketSolid<T>* laid_out, Engine engine);

  /// Classifier::first() of each ray: met[i] and boundaries[i].
  void first(std::span<const StartedRay<T>> rays, T farthest, std::vector<char>& met,
             std::vector<Boundary<T>>& boundaries);

  /// Classifier::blocked() of each ray; lights are at t = 1.
  void blocked(std::span<const StartedRay<T>> rays, T clearance, std::vector<char>& answer);

  Classifier<T>& classifier() { return classifier_; }
  const Classifier<T>& classifier() const { return classifier_; }

  /// What was found and what that took, of packets and of the Classifier: `spans`,
  /// `exact`, `packets`, `doubtful` and `costs`.
  RayCounts counts() const;

 private:
  void add(const PacketCosts& costs);

  const PacketSolid<T>* laid_out_;
  Classifier<T> classifier_;
  RayCounts counts_;  // without the Classifier's own
};

}  // namespace sir
