#include "tracer/packet_solid.h"

#include <algorithm>

#include "tracer/memory_hints.h"

namespace sir {
namespace {

template <typename T>
PacketBox<T> packet_box(const Bounds<T>& bounds) {
  PacketBox<T> box;
  for (int axis = 0; axis < 3; ++axis) {
    box.corner[0][axis] = bounds.low[axis];
    box.corner[1][axis] = bounds.high[axis];
  }
  return box;
}

}  // namespace

template <typename T>
PacketLeaf<T>::PacketLeaf(const Leaf<T>& from, std::uint32_t index)
    : unit(from.unit > 0 ? from.unit : T(1)),
      unit_error(from.unit_error),
      pace(from.pace),
      stretch(from.stretch),
      leaf(index),
      shape(from.shape),
      kind(from.kind),
      tame(from.tame),
      divided(!(from.unit > 0)),
      diagonal(true) {
  for (int i = 0; i < 3; ++i) {
    translation[i] = from.placement.translation[i];
    translation_slack[i] = from.translation_slack[i];
    origin_weight[i] = from.origin_weight[i];
    direction_weight[i] = from.direction_weight[i];
    divisors[i] = from.placement.divisors[i];
    for (int row = 0; row < 3; ++row) {
      const T entry = from.placement.numerators[i][row];
      numerators[3 * i + row] = entry;
      if (i != row && entry != 0) diagonal = false;
    }
  }
}

template <typename T>
PacketSolid<T>::PacketSolid(const Solid<T>& solid)
    : chain(2 * Numeric<T>::kCoincidentUlps * Numeric<T>::kEpsilon *
            static_cast<T>(2 * std::size_t(solid.products.crowd) + 2)),
      spread(solid.spread),
      gap(solid.products.gap) {
  const Products<T>& products = solid.products;
  const auto from = products.hierarchy.nodes();
  shapes.reserve(solid.leaves.size());
  nodes.reserve(from.size());
  parts.reserve(products.list.size());
  reserve_all(leaves, products.leaves.size());
  for (const Leaf<T>& leaf : solid.leaves) shapes.push_back(leaf.shape);
  for (const auto& node : from) {
    nodes.push_back({packet_box(node.bounds), node.first, node.size});
    if (node.size > 0) continue;
    const auto between = from[node.first + 1].bounds.centre() - from[node.first].bounds.centre();
    std::uint8_t widest = 0;
    for (std::uint8_t axis = 1; axis < 3; ++axis)
      if (std::abs(between[axis]) > std::abs(between[widest])) widest = axis;
    nodes.back().axis = widest;
    nodes.back().ascending = between[widest] >= 0;
  }
  const auto order = products.hierarchy.order();
  const auto boxes = products.hierarchy.boxes();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ProductRange& range = products.list[order[i]];
    parts.push_back({packet_box(boxes[i]), static_cast<std::uint32_t>(leaves.size()),
                     range.positives, range.negatives});
    all_alone = all_alone && range.positives == 1 && range.negatives == 0;
    for (std::uint32_t k = 0; k < range.positives + range.negatives; ++k) {
      const std::uint32_t leaf = products.leaves[range.first + k];
      leaves.emplace_back(solid.leaves[leaf], leaf);
    }
  }
}

// Codes of leaf and face have 32 bits.
constexpr std::size_t kMostPacketLeaves = std::size_t{1} << 27;

template <typename T>
std::shared_ptr<const PacketSolid<T>> lay_out(const Solid<T>& solid) {
  if constexpr (!std::is_same_v<T, long double>)
    if (solid.textbook.empty() && solid.products.complete &&
        solid.leaves.size() <= kMostPacketLeaves)
      return std::make_shared<PacketSolid<T>>(solid);
  return {};
}

template struct PacketLeaf<float>;
template struct PacketLeaf<double>;
template struct PacketSolid<float>;
template struct PacketSolid<double>;
template std::shared_ptr<const PacketSolid<float>> lay_out(const Solid<float>&);
template std::shared_ptr<const PacketSolid<double>> lay_out(const Solid<double>&);
template std::shared_ptr<const PacketSolid<long double>> lay_out(const Solid<long double>&);

}  // namespace sir
