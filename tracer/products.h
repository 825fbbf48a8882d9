// The solid as a union of products (thesis 2.5: the cures for Roth's costs): the
// composition distributed until every part is an intersection of some primitives
// less some others, which one can be asked about without the rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/hierarchy.h"

namespace sir {

template <typename T>
struct Solid;

/// One part: the points inside of all `positives` and of none of `negatives`.
struct ProductRange {
  std::uint32_t first = 0;      ///< its primitives are leaves[first ..], positives first
  std::uint32_t positives = 0;  ///< at least 1
  std::uint32_t negatives = 0;
};

/// All parts; their union is the solid. Primitives may be in several. A primitive
/// that is further than `gap` from all that a part could hold is not in it.
template <typename T>
struct Products {
  std::vector<ProductRange> list;
  std::vector<std::uint32_t> leaves;  ///< indices into Solid::leaves
  Hierarchy<T> hierarchy;             ///< over the parts' envelopes, in the order of `list`
  bool complete = false;    ///< false: distributing would have taken too many; there are none
  T gap = 0;                ///< in SC_CENA. What is one event on a ray may not reach as far: else
                            ///< a primitive that was left out of a part could be one with it
  std::uint32_t crowd = 0;  ///< no more primitives come as near as `gap` to one point; known
                            ///< where not complete too
};

/// Distributes differences and intersections over unions, guided by envelopes:
/// (A+B)-C = (A-C)+(B-C), A-(B-C) = (A-B)+(A*C), A-(B*C) = (A-B)+(A-C) and so on,
/// where what a part's envelope does not meet is left out of it, and parts that
/// must be empty are left out themselves. Never recurses. `boxes`: the leaves'
/// envelopes. Gives up where there would be more than kMostParts parts for each
/// leaf, or where that takes too many steps.
template <typename T>
Products<T> build_products(const Solid<T>& solid, std::span<const Bounds<T>> boxes);

inline constexpr std::size_t kMostParts = 8;

}  // namespace sir
