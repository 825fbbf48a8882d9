// Envelopes on the tree of composition as it is given (thesis 2.5.2): Roth's own
// cure, without any thought of a better tree. What it saves hangs on the tree's
// shape; kept to be measured beside the hierarchy over the geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/cost_counts.h"
#include "tracer/solid.h"

namespace sir {

/// A node of the composition that a ray comes to.
struct Visit {
  std::uint32_t step = 0;  ///< index into Solid::polish
  bool entered = false;    ///< its envelope is met; else it and all below it are OUT
};

/// A box for every node: a primitive's; of a union the box around both, of an
/// intersection what both have in common, of a difference the left one's.
template <typename T>
class EnvelopeTree {
 public:
  explicit EnvelopeTree(const Solid<T>& solid);

  /// The nodes that the ray comes to at t in [0, farthest], in reverse Polish
  /// order. Adds to the envelopes and the calls.
  void visit(const BoxProbe<T>& probe, T farthest, std::vector<Visit>& visits,
             CostCounts& costs) const;

 private:
  std::vector<Bounds<T>> boxes_;      // of each step of the reverse Polish order
  std::vector<std::uint32_t> sizes_;  // steps of the node's tree, itself among them
};

}  // namespace sir
