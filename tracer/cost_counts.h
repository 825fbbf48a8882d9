// What the algorithm of Roth costs, and what is left of it (thesis 2.5).
#pragma once

#include <array>
#include <cstdint>

#include "tracer/intersect.h"

namespace sir {

/// The four costs of thesis 2.5, and the envelopes (2.5.2) that save them; over
/// all rays of every kind.
///
/// By the plain algorithm a ray costs, on a tree of n primitives, 2n - 1 calls,
/// n - 1 combinations, n transformations, and as many intersection tests as the
/// primitives have surfaces: thesis 2.5's 600, 300, 300 and 4 x 300, which Roth
/// rounds. (A secondary ray leaves out the primitive that it leaves.) Any other
/// engine counts the same work where it still does it.
///
/// Where the first boundary is found by products (Solid::products) nothing is
/// combined: combinations are left only on the rays that this leaves in doubt, and on
/// shadow rays through glass. A packet takes its rays along together: a node that it
/// goes into, a box that it is tested against, counts for each of its rays that is
/// still sought for; a primitive, for the rays that meet the box of its part, once for
/// each part that it is in. The box tests that list a tile's parts count once for all
/// of its rays. So the sums of packets, alone of all counts, hang on which
/// rays are in a packet: it is their majority that says which child is the nearer one,
/// and what is found there that ends the walk. They do not depend on the processor or
/// the number of threads.
struct CostCounts {
  /// CUSTO 1: nodes gone into. Of the composition; or of the hierarchy of
  /// envelopes, and the primitives that these let through, as often as they were tested.
  std::uint64_t calls = 0;
  /// CUSTO 2: composites whose two lists were combined; or inputs of gates that
  /// changed on the way along the ray.
  std::uint64_t combinations = 0;
  /// Boxes that a ray was tested against.
  std::uint64_t envelopes = 0;
  /// Primitives that a ray was taken to and tested against, by PrimitiveKind.
  std::array<std::uint64_t, 4> primitives{};

  /// CUSTO 3: rays taken from SC_CENA to the SC_LOCAL of a primitive.
  std::uint64_t transformations() const {
    return primitives[0] + primitives[1] + primitives[2] + primitives[3];
  }

  /// CUSTO 4: rays against surfaces, a cube having 6, a sphere 1, a cone 2, a
  /// cylinder 3.
  std::uint64_t intersection_tests() const {
    std::uint64_t tests = 0;
    for (std::size_t kind = 0; kind < primitives.size(); ++kind)
      tests += primitives[kind] *
               static_cast<std::uint64_t>(face_count(static_cast<PrimitiveKind>(kind)));
    return tests;
  }

  friend bool operator==(const CostCounts&, const CostCounts&) = default;

  CostCounts& operator+=(const CostCounts& other) {
    calls += other.calls;
    combinations += other.combinations;
    envelopes += other.envelopes;
    for (std::size_t kind = 0; kind < primitives.size(); ++kind)
      primitives[kind] += other.primitives[kind];
    return *this;
  }

  /// What has come since `before`.
  CostCounts since(const CostCounts& before) const {
    CostCounts result{calls - before.calls, combinations - before.combinations,
                      envelopes - before.envelopes, primitives};
    for (std::size_t kind = 0; kind < primitives.size(); ++kind)
      result.primitives[kind] -= before.primitives[kind];
    return result;
  }
};

}  // namespace sir
