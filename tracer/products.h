// The solid as a union of products (thesis 2.5: the cures for Roth's costs): the
// composition distributed until every part is an intersection of some primitives
// less some others, which one can be asked about without the rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/hierarchy.h"
#include "tracer/solid.h"

namespace sir {

/// One part: the points inside of all `positives` and of none of `negatives`.
struct ProductRange {
  std::uint32_t first = 0;      ///< its primitives are leaves[first ..], positives first
  std::uint32_t positives = 0;  ///< at least 1
  std::uint32_t negatives = 0;
};

/// All parts; their union is the solid. Primitives may be in several.
template <typename T>
struct Products {
  std::vector<ProductRange> list;
  std::vector<std::uint32_t> leaves;  ///< indices into Solid::leaves
  Hierarchy<T> hierarchy;             ///< over the parts' envelopes, in the order of `list`
  bool complete = false;  ///< false: distributing would have taken too many; there are none
};

}  // namespace sir
