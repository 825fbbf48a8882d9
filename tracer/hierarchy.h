// A tree of envelopes over the primitives (thesis 2.5.2; Clark 1976): the
// geometry decides it, not the composition, so a chain is as good as a balanced
// tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/bounds.h"

namespace sir {

/// Boxes that a ray was tested against, and nodes whose box it met.
struct HierarchyCosts {
  std::uint64_t envelopes = 0, entered = 0;
};

template <typename T>
class Hierarchy {
 public:
  Hierarchy() = default;

  /// Over boxes[0..n): halves at the median of the centres along the longest
  /// axis, down to a few boxes.
  explicit Hierarchy(std::span<const Bounds<T>> boxes);

  /// Calls visit(i) for each box i that the ray may meet at t in [0, farthest],
  /// in an order that depends on the hierarchy only, until a visit returns true.
  /// Returns what it took.
  template <typename Visit>
  HierarchyCosts for_each_met(const BoxProbe<T>& probe, T farthest, Visit&& visit) const {
    HierarchyCosts costs;
    if (nodes_.empty()) return costs;
    std::array<std::uint32_t, kMaxDepth> open;
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[open[--count]];
      ++costs.envelopes;
      if (!probe.meets(node.bounds, farthest)) continue;
      ++costs.entered;
      if (node.size == 0) {
        open[count++] = node.first + 1;
        open[count++] = node.first;
        continue;
      }
      if (node.size > 1) costs.envelopes += node.size;
      for (std::uint32_t i = node.first; i < node.first + node.size; ++i)
        if ((node.size == 1 || probe.meets(boxes_[i], farthest)) && visit(order_[i])) return costs;
    }
    return costs;
  }

  /// The envelope of everything.
  Bounds<T> bounds() const { return nodes_.empty() ? Bounds<T>{} : nodes_[0].bounds; }

 private:
  struct Node {
    Bounds<T> bounds;
    std::uint32_t first = 0;  ///< inner: its children are first and first + 1;
                              ///< leaf: its boxes are order_[first .. first + size)
    std::uint32_t size = 0;   ///< 0: inner
  };
  static constexpr std::size_t kMaxDepth = 64;  // halving: 2^64 boxes would fit
  static constexpr std::uint32_t kLeafSize = 2;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds<T>> boxes_;  ///< in the order of order_
};

}  // namespace sir
