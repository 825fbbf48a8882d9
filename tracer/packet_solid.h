// The solid laid out for packets: the parts' primitives side by side in the order
// in which they are asked, every constant of the way to SC_LOCAL ready.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/solid.h"

namespace sir {

/// A primitive: what Leaf::to_local() and the intersections take from it. Arrays
/// of nine are matrices column by column.
template <typename T>
struct PacketLeaf {
  explicit PacketLeaf(const Leaf<T>& leaf, std::uint32_t index);

  T translation[3], translation_slack[3];
  T numerators[9];  ///< of LOCAL_CENA's inverse
  T origin_weight[3], direction_weight[3], divisors[3];
  T unit = 1, unit_error = 0;
  T pace = 1, stretch = 1;
  std::uint32_t leaf = 0, shape = 0;  ///< index into Solid::leaves; Leaf::shape
  PrimitiveKind kind = PrimitiveKind::cube;
  bool tame = false;
  bool divided = false;   ///< the rows have divisors of their own (Leaf::unit is 0)
  bool diagonal = false;  ///< axes go to axes
};

/// Envelope of a node or of a part; empty where low > high.
template <typename T>
struct PacketBox {
  T corner[2][3];  ///< low, high
};

template <typename T>
struct PacketNode {
  PacketBox<T> box;
  std::uint32_t first = 0;  ///< inner: the children are first and first + 1; else parts
  std::uint32_t size = 0;   ///< 0: inner
  std::uint8_t axis = 0;    ///< inner: along which the children lie apart
  bool ascending = true;    ///< the first child lies lower there
};

/// A union of parts: Solid::products, in the order of their hierarchy.
template <typename T>
struct PacketSolid {
  /// The solid's products must be complete.
  explicit PacketSolid(const Solid<T>& solid);

  struct Part {
    PacketBox<T> box;
    std::uint32_t first = 0;  ///< its primitives are leaves[first ..], positives first
    std::uint32_t positives = 0, negatives = 0;
  };

  std::vector<PacketNode<T>> nodes;  ///< the root first; children in pairs
  std::vector<Part> parts;
  std::vector<PacketLeaf<T>> leaves;
  std::vector<std::uint32_t> shapes;  ///< of Solid::leaves
  bool all_alone = true;              ///< each part is one primitive
  T chain = 0;   ///< boundaries that are one event reach no further, relative to t
  T spread = 0;  ///< Solid::spread
  T gap = 0;     ///< nor may that be further than this, in SC_CENA (Products::gap)
};

/// The solid laid out for packets; null where they cannot serve it: it is not a
/// union of products, was built for Formulas::textbook, or T is long double.
template <typename T>
std::shared_ptr<const PacketSolid<T>> lay_out(const Solid<T>& solid);

}  // namespace sir
