// A primitive as rays with a start see it (Classifier::gather() to its end), and
// the walk over the parts that a packet may meet.
#if defined(SIR_TRACER_PACKET_MEET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_MEET_INL_H_
#undef SIR_TRACER_PACKET_MEET_INL_H_
#else
#define SIR_TRACER_PACKET_MEET_INL_H_
#endif

#include <algorithm>

#include "tracer/packet_kinds-inl.h"
#include "tracer/part_list.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

/// What names a boundary, in one word: leaf, face, leaf_entering, entering.
inline constexpr std::uint32_t kEntering = 1, kLeafEntering = 2;
inline constexpr int kFaceShift = 2, kLeafShift = 5;

/// A span that is known, of each lane in `met`, and that ends behind the start or
/// where the start is.
template <typename T>
struct Met {
  Numbers<T> enter, leave, enter_error, leave_error;
  Codes<T> enter_face, leave_face;
  Truths<T> met;
  Truths<T> unsure;  ///< the primitive may be met, and only more digits tell where
  std::uint32_t leaf;

  HWY_INLINE Codes<T> enter_code() const {
    return code(enter_face) | Codes<T>(leaf << kLeafShift | kLeafEntering);
  }
  HWY_INLINE Codes<T> leave_code() const { return code(leave_face) | Codes<T>(leaf << kLeafShift); }

 private:
  static HWY_INLINE Codes<T> code(Codes<T> face) { return {hn::ShiftLeft<kFaceShift>(face.v)}; }
};

template <typename T>
HWY_INLINE void meet(const PacketLeaf<T>& leaf, const ReadyPacket<T>& rays, std::size_t lane,
                     Truths<T> where, Met<T>& seen, PacketCosts& costs) {
  using V = Numbers<T>;
  seen.leaf = leaf.leaf;
  Truths<T> inward = Truths<T>::none();
  if (rays.start_ends) {
    const Codes<T> shape(leaf.shape);
    where -= Codes<T>::load(rays.away_shape + lane) == shape;
    inward = where & (Codes<T>::load(rays.inward_shape + lane) == shape);
  }
  costs.counts.primitives[static_cast<std::size_t>(leaf.kind)] += where.count();
  Spans<T> spans;
  cross(leaf, rays, lane, where, spans);
  seen.unsure = spans.unsure;
  seen.met = spans.crosses;
  seen.enter = spans.enter;
  seen.leave = spans.leave;
  seen.enter_error = spans.enter_error;
  seen.leave_error = spans.leave_error;
  seen.enter_face = spans.enter_face;
  seen.leave_face = spans.leave_face;
  if (!spans.crosses.any()) return;
  const V zero(T(0));
  if (rays.start_ends) {
    // Entered at the start: before all that follows it.
    seen.enter = select(inward, V(T(-1)), seen.enter);
    seen.enter_error = select(inward, zero, seen.enter_error);
    seen.met -= inward & (seen.leave <= zero);
  }
  seen.met = (seen.met - (seen.leave < -seen.leave_error)) & (seen.enter < seen.leave);
  if (rays.start_ends) {
    const Truths<T> joined = (seen.met & spans.near_start) - inward;
    seen.unsure |= joined;
    seen.met -= joined;
  }
  costs.spans += seen.met.count();
}

/// The parts whose envelopes some lanes meet at t in [0, reach[lane]], about front
/// to back: visitor.visit(part, lane, where, enter) for each chunk of a packet that
/// does. The visitor may draw `reach` nearer; below 0 a lane is finished. Adds to
/// visitor.costs for each of the visitor.alive() lanes that are not.
template <typename T, typename Visitor>
HWY_INLINE void walk(const PacketSolid<T>& solid, const ReadyPacket<T>& rays, const T* reach,
                     Visitor& visitor) {
  using V = Numbers<T>;
  constexpr std::size_t kStep = hn::MaxLanes(Chunk<T>());
  if (solid.nodes.empty() || rays.tame == 0) return;
  std::uint32_t open[Hierarchy<T>::kMaxDepth + 1];
  std::size_t count = 0;
  open[count++] = 0;
  std::uint32_t calls = 0, envelopes = 0;
  while (count > 0) {
    const PacketNode<T>& node = solid.nodes[open[--count]];
    const std::uint32_t alive = visitor.alive();
    if (node.size == 0) {
      envelopes += alive;
      for (std::size_t lane = 0; lane < kPacketLanes; lane += kStep) {
        V enter;
        if (!meets(node.box, rays, lane, V::load(reach + lane), enter).any()) continue;
        const std::uint32_t far = node.ascending != rays.descending[node.axis] ? 1 : 0;
        open[count++] = node.first + far;
        open[count++] = node.first + 1 - far;
        calls += alive;
        break;
      }
      continue;
    }
    calls += alive;
    envelopes += alive * node.size;
    for (std::uint32_t i = node.first; i < node.first + node.size; ++i) {
      const auto& part = solid.parts[i];
      for (std::size_t lane = 0; lane < kPacketLanes; lane += kStep) {
        V enter;
        const Truths<T> where = meets(part.box, rays, lane, V::load(reach + lane), enter);
        if (where.any()) visitor.visit(part, lane, where, enter);
      }
    }
  }
  visitor.costs.counts.calls += calls;
  visitor.costs.counts.envelopes += envelopes;
}

/// The same over a tile's list.
template <typename T, typename Visitor>
HWY_INLINE void walk_list(const PacketSolid<T>& solid, const ReadyPacket<T>& rays,
                          std::span<const typename PartList<T>::Entry> list, const T* reach,
                          Visitor& visitor) {
  using V = Numbers<T>;
  constexpr std::size_t kStep = hn::MaxLanes(Chunk<T>());
  if (rays.tame == 0) return;
  std::uint32_t envelopes = 0;
  for (const auto& [from, index] : list) {
    const auto& part = solid.parts[index];
    const std::uint32_t alive = visitor.alive();
    bool finished = true;
    for (std::size_t lane = 0; lane < kPacketLanes; lane += kStep) {
      const V far = V::load(reach + lane);
      if (!(far >= V(from)).any()) continue;
      finished = false;
      V enter;
      const Truths<T> where = meets(part.box, rays, lane, far, enter);
      if (where.any()) visitor.visit(part, lane, where, enter);
    }
    if (finished) break;  // the others begin behind this one
    envelopes += alive;
  }
  visitor.costs.counts.envelopes += envelopes;
}

/// How far the walk goes at first: -1 for lanes that are not tame. Finite, so that
/// infinity is beyond it.
template <typename T>
HWY_INLINE void set_reach(const ReadyPacket<T>& rays, const T* farthest, T* reach) {
  constexpr T kMost = std::numeric_limits<T>::max() / 2;
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane)
    reach[lane] = rays.tame >> lane & 1u ? std::min(farthest[lane], kMost) : T(-1);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_MEET_INL_H_
