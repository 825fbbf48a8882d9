#include "tracer/packet_first.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/packet_first.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "tracer/packet_change-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

// The earliest change so far, and how near another comes to it.
template <typename T>
class FirstSearch {
  using V = Numbers<T>;
  using Word = typename Codes<T>::Word;

 public:
  HWY_INLINE FirstSearch(const PacketSolid<T>& solid, const ReadyPacket<T>& rays, const T* farthest)
      : solid_(solid),
        changer_(solid, rays, costs),
        alive_(static_cast<std::uint32_t>(std::popcount(rays.tame))) {
    set_reach(rays, farthest, reach);
    std::fill_n(t_, kPacketLanes, std::numeric_limits<T>::infinity());
    std::fill_n(rival_, kPacketLanes, std::numeric_limits<T>::infinity());
  }

  HWY_INLINE void visit(const typename PacketSolid<T>::Part& part, std::size_t lane,
                        Truths<T> where, V enter) {
    Change<T> change;
    changer_.find(part, lane, where, enter, V::load(reach + lane), change);
    if ((change.certain | change.doubtful).any()) note(lane, change);
  }

  HWY_INLINE void finish(const ReadyPacket<T>& rays, PacketFirst<T>& found) const {
    std::uint32_t hit = 0, clear = 0;
    const V infinity(std::numeric_limits<T>::infinity()), chain(solid_.chain), one(T(1)), two(T(2));
    const V trust(Numeric<T>::kTrustedRoundings * Numeric<T>::kEpsilon);
    for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
      const V t = V::load(t_ + lane), error = V::load(error_ + lane), end = t + error;
      const V rival = V::load(rival_ + lane);
      const Codes<T> entering = Codes<T>::load(code_ + lane) & Codes<T>(kEntering);
      const Truths<T> any = t < infinity;
      const Truths<T> leaves = (V::load(around_ + lane) == V(T(0))) | (entering == Codes<T>(0u));
      const Truths<T> known = (t > error) & (error <= trust * (t + V::load(rays.start_t + lane)));
      const Truths<T> narrow =
          (error + two * chain * end) * V::load(rays.speed + lane) <= V(solid_.gap);
      const Truths<T> alone =
          (any & leaves & known & narrow & (rival > end * (one + two * chain))) |
          ((rival == infinity) - any);
      hit |= any.bits() << lane;
      clear |= alone.bits() << lane;
    }
    found.missed = rays.still | (rays.tame & clear & ~hit);
    found.hit = rays.tame & clear & hit;
    found.doubtful = rays.wild | (rays.tame & ~clear);
    for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
      if (!(found.hit >> lane & 1u)) continue;
      const auto code = static_cast<std::uint32_t>(code_[lane]);
      found.boundary[lane] = {
          t_[lane] + T(0),         error_[lane],
          code >> kLeafShift,      static_cast<std::uint8_t>(code >> kFaceShift & 7u),
          (code & kEntering) != 0, (code & kLeafEntering) != 0};
    }
  }

  HWY_INLINE std::uint32_t alive() const { return alive_; }

  alignas(64) T reach[kPacketLanes];
  PacketCosts costs;

 private:
  HWY_INLINE void note(std::size_t lane, const Change<T>& change) {
    const V infinity(std::numeric_limits<T>::infinity());
    V rival = V::load(rival_ + lane);
    rival = select(change.doubtful, lesser(rival, change.least), rival);
    V t = V::load(t_ + lane), error = V::load(error_ + lane);
    if (change.certain.any()) {
      Codes<T> code = Codes<T>::load(code_ + lane);
      const Truths<T> better = change.certain & (change.t < t);
      // Parts that one primitive's surface ends together change together.
      const Truths<T> other = change.certain - (change.code == code);
      rival = select(other, lesser(rival, select(better, t - error, change.least)), rival);
      if (change.inside.any()) {
        const V around = V::load(around_ + lane);
        rival = select(change.inside & (around > V(T(0))), V(T(-1)), rival);
        select(change.inside, V(T(1)), around).store(around_ + lane);
      }
      t = select(better, change.t, t);
      error = select(better, change.error, error);
      t.store(t_ + lane);
      error.store(error_ + lane);
      select(better, change.code, code).store(code_ + lane);
    }
    rival.store(rival_ + lane);
    const V needed = lesser(t + error, rival) * V(1 + 4 * solid_.chain);
    lesser(V::load(reach + lane), needed).store(reach + lane);
  }

  alignas(64) T t_[kPacketLanes], error_[kPacketLanes] = {}, rival_[kPacketLanes];
  alignas(64) T around_[kPacketLanes] = {};  // 1: a part is around the start
  alignas(64) Word code_[kPacketLanes] = {};
  const PacketSolid<T>& solid_;
  Changer<T> changer_;
  const std::uint32_t alive_;
};

template <typename T>
HWY_INLINE void find_first(const PacketSolid<T>& solid, const RayPacket<T>& packet,
                           const PartList<T>* list, PacketFirst<T>& found) {
  const ReadyPacket<T> rays(packet, &solid);
  FirstSearch<T> search(solid, rays, packet.farthest);
  if (list) walk_list<T>(solid, rays, list->entries(), search.reach, search);
  else walk(solid, rays, search.reach, search);
  search.finish(rays, found);
  found.costs = search.costs;
}

void first_floats(const PacketSolid<float>& solid, const RayPacket<float>& rays,
                  const PartList<float>* list, PacketFirst<float>& found) {
  find_first(solid, rays, list, found);
}
void first_doubles(const PacketSolid<double>& solid, const RayPacket<double>& rays,
                   const PartList<double>* list, PacketFirst<double>& found) {
  find_first(solid, rays, list, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tracer/packet_target.h"

namespace sir {

template <>
PacketFirst<float> first_boundaries(const PacketSolid<float>& solid, const RayPacket<float>& rays,
                                    const PartList<float>* list) {
  PacketFirst<float> found;
  SIR_DISPATCH(first_floats)(solid, rays, list, found);
  return found;
}

template <>
PacketFirst<double> first_boundaries(const PacketSolid<double>& solid,
                                     const RayPacket<double>& rays, const PartList<double>* list) {
  PacketFirst<double> found;
  SIR_DISPATCH(first_doubles)(solid, rays, list, found);
  return found;
}

}  // namespace sir
#endif
