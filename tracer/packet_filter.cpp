#include "tracer/packet_filter.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/packet_filter.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "tracer/packet_meet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

// The parts that each ray passes, nearest first.
template <typename T>
class FilterSearch {
  using V = Numbers<T>;
  using B = Truths<T>;
  using Word = typename Codes<T>::Word;
  static constexpr std::size_t kMost = PacketFilter<T>::kMostParts;
  static constexpr T kInfinity = std::numeric_limits<T>::infinity();

 public:
  HWY_INLINE FilterSearch(const PacketSolid<T>& solid, const ReadyPacket<T>& rays)
      : solid_(solid), rays_(rays), alive_(static_cast<std::uint32_t>(std::popcount(rays.tame))) {
    alignas(64) T light[kPacketLanes];
    std::fill_n(light, kPacketLanes, T(1));
    set_reach(rays, light, reach);
    for (Passage& passage : passages_) std::fill_n(passage.enter, kPacketLanes, kInfinity);
  }

  HWY_INLINE void visit(const typename PacketSolid<T>::Part& part, std::size_t lane, B where, V) {
    Met<T> seen;
    meet(solid_.leaves[part.first], rays_, lane, where, seen, costs);
    B vague = seen.unsure;
    if (seen.met.any()) {
      if (part.positives != 1 || part.negatives != 0) vague |= seen.met;
      else note(lane, seen, vague);
    }
    if (!vague.any()) return;
    doubtful_ |= vague.bits() << lane;
    select(vague, V(T(-1)), V::load(reach + lane)).store(reach + lane);
  }

  HWY_INLINE void finish(PacketFilter<T>& found) const;

  HWY_INLINE std::uint32_t alive() const { return alive_; }

  alignas(64) T reach[kPacketLanes];
  PacketCosts costs;

 private:
  // A part that a ray passes; enter is infinite where there is none, -1 where the ray
  // starts inside. What is entered or left behind the light does not count.
  struct Passage {
    alignas(64) T enter[kPacketLanes], leave[kPacketLanes];
    alignas(64) T enter_error[kPacketLanes], leave_error[kPacketLanes];
    alignas(64) Word enter_code[kPacketLanes], leave_code[kPacketLanes];
  };

  // Whether an end is surely before the light or surely behind it, and well known.
  HWY_INLINE B before_light(V t, V error, std::size_t lane, B where, B& vague) const {
    const V one(T(1)), margin = error + V(2 * solid_.chain) * (one + error);
    const B before = where & (t < one - margin);
    const V trust(Numeric<T>::kTrustedRoundings * Numeric<T>::kEpsilon);
    const B known = error <= trust * (t + V::load(rays_.start_t + lane));
    const B narrow =
        (error + V(2 * solid_.chain) * (t + error)) * V::load(rays_.speed + lane) <= V(solid_.gap);
    vague |= (where - before) - (t > one + margin);
    vague |= before - (known & narrow);
    return before;
  }

  HWY_INLINE void note(std::size_t lane, const Met<T>& seen, B& vague) {
    const V zero(T(0)), chain(solid_.chain);
    const B outside = seen.met & (seen.enter > seen.enter_error);
    const B inside = seen.met & (seen.enter < -seen.enter_error) & (seen.leave > seen.leave_error);
    const B thick =
        seen.leave - seen.enter > seen.enter_error + seen.leave_error + V(2) * chain * seen.leave;
    const B certain = (outside & thick) | inside;
    vague |= seen.met - certain;
    const B entered = before_light(seen.enter, seen.enter_error, lane, certain & outside, vague);
    const B met = (entered | inside) - vague;
    if (!met.any()) return;
    const B left = before_light(seen.leave, seen.leave_error, lane, met, vague);
    insert(lane, met - vague, select(inside, V(T(-1)), seen.enter),
           select(inside, zero, seen.enter_error), select(left, seen.leave, V(kInfinity)),
           select(left, seen.leave_error, zero), seen.enter_code() | Codes<T>(kEntering),
           seen.leave_code(), vague);
  }

  HWY_INLINE void insert(std::size_t lane, B where, V enter, V enter_error, V leave, V leave_error,
                         Codes<T> enter_code, Codes<T> leave_code, B& vague);

  const PacketSolid<T>& solid_;
  const ReadyPacket<T>& rays_;
  Passage passages_[kMost];
  std::uint32_t doubtful_ = 0;
  const std::uint32_t alive_;  // lanes
};

// Among those found before; the last of too many is no room for.
template <typename T>
HWY_INLINE void FilterSearch<T>::insert(std::size_t lane, B where, V enter, V enter_error, V leave,
                                        V leave_error, Codes<T> enter_code, Codes<T> leave_code,
                                        B& vague) {
  const V infinity(kInfinity);
  for (Passage& passage : passages_) {
    if (!where.any()) return;
    const V old_enter = V::load(passage.enter + lane);
    const B earlier = where & (enter < old_enter);
    const V old_enter_error = V::load(passage.enter_error + lane);
    const V old_leave = V::load(passage.leave + lane);
    const V old_leave_error = V::load(passage.leave_error + lane);
    const auto old_enter_code = Codes<T>::load(passage.enter_code + lane);
    const auto old_leave_code = Codes<T>::load(passage.leave_code + lane);
    hn::BlendedStore(enter.v, earlier.m, Chunk<T>(), passage.enter + lane);
    hn::BlendedStore(enter_error.v, earlier.m, Chunk<T>(), passage.enter_error + lane);
    hn::BlendedStore(leave.v, earlier.m, Chunk<T>(), passage.leave + lane);
    hn::BlendedStore(leave_error.v, earlier.m, Chunk<T>(), passage.leave_error + lane);
    select(earlier, enter_code, old_enter_code).store(passage.enter_code + lane);
    select(earlier, leave_code, old_leave_code).store(passage.leave_code + lane);
    // The one that had the place goes on to the next.
    enter = select(earlier, old_enter, enter);
    enter_error = select(earlier, old_enter_error, enter_error);
    leave = select(earlier, old_leave, leave);
    leave_error = select(earlier, old_leave_error, leave_error);
    enter_code = select(earlier, old_enter_code, enter_code);
    leave_code = select(earlier, old_leave_code, leave_code);
    where &= enter < infinity;
  }
  vague |= where;
}

template <typename T>
HWY_INLINE void FilterSearch<T>::finish(PacketFilter<T>& found) const {
  std::uint32_t crossing = 0, apart = 0;
  const V infinity(kInfinity), zero(T(0)), chain(2 * solid_.chain);
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    V before = V(T(-1));
    B fine = zero == zero;
    for (std::size_t k = 0; k < kMost; ++k) {
      const Passage& passage = passages_[k];
      const V enter = V::load(passage.enter + lane);
      const B is = enter < infinity;
      if (k == 0) crossing |= is.bits() << lane;
      // One may be around the start, all others come one behind the other.
      const V low = enter - V::load(passage.enter_error + lane);
      if (k > 0) fine &= (low > before + chain * (enter + before)) | !is;
      before =
          select(is, V::load(passage.leave + lane) + V::load(passage.leave_error + lane), before);
    }
    apart |= fine.bits() << lane;
  }
  found.doubtful = rays_.wild | doubtful_ | (rays_.tame & ~apart);
  found.crossing = rays_.tame & crossing & ~found.doubtful;
  found.open = (rays_.still | rays_.tame) & ~(crossing | found.doubtful);
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
    if (!(found.crossing >> lane & 1u)) continue;
    std::uint8_t count = 0;
    const auto cross = [&](T t, Word word) {
      const auto code = static_cast<std::uint32_t>(word);
      found.crossed[lane][count++] = {t, code >> kLeafShift,
                                      static_cast<std::uint8_t>(code >> kFaceShift & 7u)};
    };
    for (const Passage& passage : passages_) {
      const T enter = passage.enter[lane], leave = passage.leave[lane];
      if (!(enter < kInfinity)) break;
      if (enter > 0) cross(enter, passage.enter_code[lane]);
      if (leave < kInfinity) cross(leave, passage.leave_code[lane]);
    }
    found.count[lane] = count;
  }
}

template <typename T>
HWY_INLINE void filter_lanes(const PacketSolid<T>& solid, const RayPacket<T>& packet,
                             PacketFilter<T>& found) {
  const ReadyPacket<T> rays(packet, &solid);
  FilterSearch<T> search(solid, rays);
  walk(solid, rays, search.reach, search);
  search.finish(found);
  found.costs = search.costs;
}

void filter_floats(const PacketSolid<float>& solid, const RayPacket<float>& rays,
                   PacketFilter<float>& found) {
  filter_lanes(solid, rays, found);
}
void filter_doubles(const PacketSolid<double>& solid, const RayPacket<double>& rays,
                    PacketFilter<double>& found) {
  filter_lanes(solid, rays, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tracer/packet_target.h"

namespace sir {

template <>
PacketFilter<float> find_filters(const PacketSolid<float>& solid, const RayPacket<float>& rays) {
  PacketFilter<float> found;
  SIR_DISPATCH(filter_floats)(solid, rays, found);
  return found;
}

template <>
PacketFilter<double> find_filters(const PacketSolid<double>& solid, const RayPacket<double>& rays) {
  PacketFilter<double> found;
  SIR_DISPATCH(filter_doubles)(solid, rays, found);
  return found;
}

}  // namespace sir
#endif
