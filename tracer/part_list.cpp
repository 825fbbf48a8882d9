#include "tracer/part_list.h"

#include <algorithm>
#include <array>

namespace sir {
namespace {

// All rays between the least and the largest origin and direction.
template <typename T>
class Bundle {
 public:
  explicit Bundle(std::span<const RayPacket<T>> rays) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr T kInfinity = std::numeric_limits<T>::infinity();
      T lowest = kInfinity, highest = -kInfinity, slowest = kInfinity, fastest = -kInfinity;
      for (const RayPacket<T>& packet : rays)
        for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
          if (!(packet.active >> lane & 1u)) continue;
          lowest = std::min(lowest, packet.origin[axis][lane]);
          highest = std::max(highest, packet.origin[axis][lane]);
          slowest = std::min(slowest, packet.direction[axis][lane]);
          fastest = std::max(fastest, packet.direction[axis][lane]);
        }
      low_[axis] = {lowest, slowest, 1 / slowest};
      high_[axis] = {highest, fastest, 1 / fastest};
    }
  }

  // Where one of them may be in the box at first; infinite where none ever is. Each
  // bound of t is a difference, a reciprocal and a product, whose roundings are
  // allowed for.
  T entry(const PacketBox<T>& box) const {
    T from = 0, to = std::numeric_limits<T>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      // The lowest of them is not above the box ...
      const Side& low = low_[axis];
      const T above = (box.corner[1][axis] - low.origin) * low.reciprocal;
      if (low.direction > 0) to = std::min(to, above);
      else if (low.direction < 0) from = std::max(from, above);
      else if (box.corner[1][axis] < low.origin) to = -1;
      // ... and the highest not below it.
      const Side& high = high_[axis];
      const T below = (box.corner[0][axis] - high.origin) * high.reciprocal;
      if (high.direction > 0) from = std::max(from, below);
      else if (high.direction < 0) to = std::min(to, below);
      else if (box.corner[0][axis] > high.origin) to = -1;
    }
    constexpr T kSlack = 8 * Numeric<T>::kEpsilon;
    return from * (1 - kSlack) <= to * (1 + kSlack) ? from * (1 - kSlack)
                                                    : std::numeric_limits<T>::infinity();
  }

 private:
  struct Side {
    T origin, direction, reciprocal;
  };
  Side low_[3], high_[3];
};

}  // namespace

template <typename T>
bool PartList<T>::gather(const PacketSolid<T>& solid, std::span<const RayPacket<T>> rays) {
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  entries_.clear();
  envelopes_ = 0;
  if (solid.nodes.empty()) return true;
  const Bundle<T> bundle(rays);
  std::array<std::uint32_t, Hierarchy<T>::kMaxDepth + 1> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const PacketNode<T>& node = solid.nodes[open[--count]];
    ++envelopes_;
    if (!(bundle.entry(node.box) < kInfinity)) continue;
    if (node.size == 0) {
      open[count++] = node.first + 1;
      open[count++] = node.first;
      continue;
    }
    if (entries_.size() > kMost) return false;
    envelopes_ += node.size;
    for (std::uint32_t part = node.first; part < node.first + node.size; ++part)
      if (const T from = bundle.entry(solid.parts[part].box); from < kInfinity)
        entries_.push_back({from, part});
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.from != b.from ? a.from < b.from : a.part < b.part;
  });
  return true;
}

template class PartList<float>;
template class PartList<double>;

}  // namespace sir
