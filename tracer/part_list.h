// Tile lists: the parts of the solid that neighbouring rays may meet, front to back
// (the thesis's envelopes, 2.5.2, of many rays at once).
#pragma once

#include <span>
#include <vector>

#include "tracer/packet.h"
#include "tracer/packet_solid.h"

namespace sir {

/// One for each thread, filled anew for each bundle of rays.
template <typename T>
class PartList {
 public:
  struct Entry {
    T from;              ///< no ray of the bundle meets the part's envelope at a lower t
    std::uint32_t part;  ///< index into PacketSolid::parts
  };

  /// All parts that any of these rays may meet at any t >= 0, by increasing `from`;
  /// false, and no list, where these are too many to be of use. Origins and directions
  /// are taken to be anything between the least and the largest of the bundle, axis by
  /// axis: few parts too many for the rays of a tile, any number for rays that have
  /// nothing in common.
  bool gather(const PacketSolid<T>& solid, std::span<const RayPacket<T>> rays);

  std::span<const Entry> entries() const { return entries_; }

  /// Boxes that the last bundle was tested against.
  std::uint64_t envelopes() const { return envelopes_; }

 private:
  static constexpr std::size_t kMost = 512;

  std::vector<Entry> entries_;
  std::uint64_t envelopes_ = 0;
};

}  // namespace sir
