// RAY-TRACING (thesis 2.3.6) for a packet: the first boundary on each ray, where it
// is certain which one that is.
#pragma once

#include "tracer/packet.h"
#include "tracer/packet_solid.h"
#include "tracer/part_list.h"

namespace sir {

/// Every active lane is in one of the masks. `doubtful`: rounding or coincidence
/// could decide; the Classifier knows.
template <typename T>
struct PacketFirst {
  std::uint32_t hit = 0, missed = 0, doubtful = 0;  ///< lanes
  Boundary<T> boundary[kPacketLanes];               ///< of the lanes in `hit`
  PacketCosts costs;
};

/// What Classifier::begin() and the first next() say of each ray.
///
/// A part changes its state first where the last of its positives is entered, moved
/// on over the negatives that cover that place, or, around the start, where the
/// first of its positives is left or of its negatives entered. The solid does where
/// the first of its parts does, if at most one is around the start, and that one.
/// Every comparison on the way holds by more than the errors of what is compared
/// and the reach of a chain of boundaries that are one event: so what the
/// Classifier takes into account besides cannot change the answer.
///
/// The solid must have been built for Formulas::robust. T: float or double.
/// `list`, if given, must have been gathered for these rays, alone or among others.
template <typename T>
PacketFirst<T> first_boundaries(const PacketSolid<T>& solid, const RayPacket<T>& rays,
                                const PartList<T>* list = nullptr);

}  // namespace sir
