// A tree of envelopes (thesis 2.5.2; Clark 1976) over primitives, or over parts of
// the solid: the geometry decides it, not the composition, so a chain is as good as
// a balanced tree. Split by the surface-area heuristic (Goldsmith and Salmon 1987;
// MacDonald and Booth 1990; binned, Wald 2007).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
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
  struct Node {
    Bounds<T> bounds;
    std::uint32_t first = 0;  ///< inner: its children are nodes first and first + 1;
                              ///< leaf: its boxes are order[first .. first + size)
    std::uint32_t size = 0;   ///< 0: inner
  };
  /// No path from the root is longer: so many open nodes are enough for a walk.
  static constexpr std::size_t kMaxDepth = 72;

  Hierarchy() = default;

  /// Over boxes[0..n): each node is split where the halves' surfaces, weighted by
  /// what they hold, are least; down to a few boxes. The same for the same boxes.
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

  /// The same, the nearer of two children first. `visit(i, farthest)` returns the
  /// new `farthest`, no larger than the one given: nothing that the ray meets
  /// beyond it only is visited any more, and nothing at all where it is negative.
  /// Returns what it took.
  template <typename Visit>
  HierarchyCosts for_each_met_in_order(const BoxProbe<T>& probe, T farthest, Visit&& visit) const {
    HierarchyCosts costs;
    if (nodes_.empty()) return costs;
    ++costs.envelopes;
    if (!(probe.entry(nodes_[0].bounds, farthest) <= farthest)) return costs;
    struct Open {
      std::uint32_t node;
      T entry;
    };
    std::array<Open, kMaxDepth> open;
    std::size_t count = 0;
    std::uint32_t at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      ++costs.entered;
      if (node.size == 0) {
        std::uint32_t near = node.first, far = node.first + 1;
        T near_entry = probe.entry(nodes_[near].bounds, farthest);
        T far_entry = probe.entry(nodes_[far].bounds, farthest);
        costs.envelopes += 2;
        if (far_entry < near_entry) {
          std::swap(near, far);
          std::swap(near_entry, far_entry);
        }
        if (far_entry <= farthest) open[count++] = {far, far_entry};
        if (near_entry <= farthest) {
          at = near;
          continue;
        }
      } else {
        if (node.size > 1) costs.envelopes += node.size;
        for (std::uint32_t i = node.first; i < node.first + node.size; ++i)
          if (node.size == 1 || probe.entry(boxes_[i], farthest) <= farthest)
            farthest = visit(order_[i], farthest);
      }
      do {
        if (count == 0) return costs;
        at = open[--count].node;
      } while (!(open[count].entry <= farthest));
    }
  }

  /// Calls visit(i) for each box i that comes as near as `gap` to `box`, along every
  /// axis, until a visit returns true.
  template <typename Visit>
  void for_each_near(const Bounds<T>& box, T gap, Visit&& visit) const {
    for_each_box_near(box, gap, [&](std::size_t place) { return visit(order_[place]); });
  }

  /// The same with the box's place in boxes() and order().
  template <typename Visit>
  void for_each_box_near(const Bounds<T>& box, T gap, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, kMaxDepth> open;
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[open[--count]];
      if (!node.bounds.near(box, gap)) continue;
      if (node.size == 0) {
        open[count++] = node.first + 1;
        open[count++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.size; ++i)
        if (boxes_[i].near(box, gap) && visit(i)) return;
    }
  }

  /// The envelope of everything.
  Bounds<T> bounds() const { return nodes_.empty() ? Bounds<T>{} : nodes_[0].bounds; }

  /// For walks of other kinds. Node 0 is the root; none: there are no boxes.
  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> order() const { return order_; }  ///< indices of the boxes given
  std::span<const Bounds<T>> boxes() const { return boxes_; }      ///< in the order of order()

 private:
  static constexpr std::uint32_t kLeafSize = 2;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Bounds<T>> boxes_;  ///< in the order of order_
};

}  // namespace sir
