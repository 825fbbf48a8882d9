#include "tracer/packet_blocked.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/packet_blocked.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "tracer/packet_meet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

template <typename T>
struct Stretches {
  Numbers<T> from, to;
};

// What one lane's ray is known to be in the way of: Classifier::presence().
template <typename T>
class BlockedSearch {
  using V = Numbers<T>;
  using B = Truths<T>;

 public:
  HWY_INLINE BlockedSearch(const PacketSolid<T>& solid, const ReadyPacket<T>& rays)
      : solid_(solid), rays_(rays), alive_(static_cast<std::uint32_t>(std::popcount(rays.tame))) {
    alignas(64) T light[kPacketLanes];
    std::fill_n(light, kPacketLanes, T(1));
    set_reach(rays, light, reach);
  }

  HWY_INLINE void visit(const typename PacketSolid<T>::Part& part, std::size_t lane, B where, V) {
    B present = B::none(), doubtful = B::none();
    if (part.positives == 1 && part.negatives == 0) {
      Met<T> seen;
      meet(solid_.leaves[part.first], rays_, lane, where, seen, costs);
      doubtful = seen.unsure;
      if (seen.met.any()) {
        Stretches<T> sure = whole(), possible = whole();
        narrow(seen, sure, possible);
        present = seen.met & (sure.to - sure.from > V(solid_.chain));
        doubtful |= (seen.met & (possible.from < possible.to)) - present;
      }
    } else {
      find_carved(part, lane, where, present, doubtful);
    }
    blocked_ |= present.bits() << lane;
    alive_ = static_cast<std::uint32_t>(std::popcount(rays_.tame & ~blocked_));
    doubtful_ |= doubtful.bits() << lane;
    select(present, V(T(-1)), V::load(reach + lane)).store(reach + lane);
  }

  HWY_INLINE void finish(PacketBlocked& found) const {
    found.blocked = blocked_;
    found.doubtful = (rays_.wild | doubtful_) & ~blocked_;
    found.open = (rays_.still | rays_.tame) & ~(blocked_ | doubtful_);
    found.costs = costs;
  }

  HWY_INLINE std::uint32_t alive() const { return alive_; }

  alignas(64) T reach[kPacketLanes];
  PacketCosts costs;

 private:
  static constexpr std::size_t kMostCarved = 24;

  static HWY_INLINE Stretches<T> whole() { return {V(T(0)), V(T(1))}; }

  static HWY_INLINE void narrow(const Met<T>& seen, Stretches<T>& sure, Stretches<T>& possible) {
    sure = {select(seen.met, greater(sure.from, seen.enter + seen.enter_error), sure.from),
            select(seen.met, lesser(sure.to, seen.leave - seen.leave_error), sure.to)};
    possible = {
        select(seen.met, greater(possible.from, seen.enter - seen.enter_error), possible.from),
        select(seen.met, lesser(possible.to, seen.leave + seen.leave_error), possible.to)};
  }

  HWY_NOINLINE void find_carved(const typename PacketSolid<T>::Part& part, std::size_t lane,
                                B where, B& present, B& doubtful);

  const PacketSolid<T>& solid_;
  const ReadyPacket<T>& rays_;
  std::uint32_t blocked_ = 0, doubtful_ = 0;
  std::uint32_t alive_;  // lanes
};

// Classifier::presence_of().
template <typename T>
HWY_NOINLINE void BlockedSearch<T>::find_carved(const typename PacketSolid<T>::Part& part,
                                                std::size_t lane, B where, B& present,
                                                B& doubtful) {
  struct Gap {
    V enter_low, enter_high, leave_low, leave_high;
    B met;
  };
  const V infinity(std::numeric_limits<T>::infinity()), slack(solid_.chain);
  Stretches<T> sure = whole(), possible = whole();
  B alive = where, vague = B::none();
  Met<T> seen;
  for (std::uint32_t k = 0; k < part.positives; ++k) {
    meet(solid_.leaves[part.first + k], rays_, lane, alive, seen, costs);
    alive &= seen.met | seen.unsure;
    vague |= seen.unsure;
    narrow(seen, sure, possible);
    alive &= possible.from < possible.to;
    if (!alive.any()) return;
  }
  Gap gaps[kMostCarved];
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < part.negatives; ++k) {
    meet(solid_.leaves[part.first + part.positives + k], rays_, lane, alive, seen, costs);
    vague |= seen.unsure;
    if (!seen.met.any()) continue;
    if (count == kMostCarved) {
      vague |= seen.met;
      continue;
    }
    gaps[count++] = {seen.enter - seen.enter_error, seen.enter + seen.enter_error,
                     seen.leave - seen.leave_error, seen.leave + seen.leave_error, seen.met};
  }
  // Some stretch that surely nothing is taken from.
  B asked = alive - vague;
  for (std::size_t round = 0; round <= count && asked.any(); ++round) {
    for (B again = asked; again.any();) {
      again = B::none();
      for (std::size_t k = 0; k < count; ++k) {
        const B moves = (asked & gaps[k].met & (gaps[k].leave_high > sure.from)) -
                        (gaps[k].enter_low > sure.from + slack);
        sure.from = select(moves, gaps[k].leave_high, sure.from);
        again |= moves;
      }
    }
    V to = sure.to;
    for (std::size_t k = 0; k < count; ++k)
      to = select(gaps[k].met & (gaps[k].enter_low > sure.from), lesser(to, gaps[k].enter_low), to);
    present |= asked & (to - sure.from > slack);
    sure.from = select(asked, to, sure.from);
    asked = (asked - present) & (sure.from < sure.to);
  }
  for (B again = alive; again.any();) {
    again = B::none();
    for (std::size_t k = 0; k < count; ++k) {
      const B moves = (alive & gaps[k].met & (gaps[k].leave_low > possible.from)) -
                      (gaps[k].enter_high > possible.from);
      possible.from = select(moves, gaps[k].leave_low, possible.from);
      again |= moves;
    }
  }
  doubtful = (alive & (possible.from < possible.to)) - present;
}

template <typename T>
HWY_INLINE void find_lanes(const PacketSolid<T>& solid, const RayPacket<T>& packet, T clearance,
                           PacketBlocked& found) {
  const T roundings = Numeric<T>::kBoxRoundings * Numeric<T>::kEpsilon;
  ReadyPacket<T> rays(packet, &solid);
  std::uint32_t clear = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
    const T far = std::max({std::abs(rays.origin[0][lane]), std::abs(rays.origin[1][lane]),
                            std::abs(rays.origin[2][lane])});
    const T speed = rays.speed[lane];
    if (solid.chain * speed <= solid.gap &&
        solid.chain * speed + roundings * (far + speed) < clearance)
      clear |= 1u << lane;
  }
  rays.wild |= rays.tame & ~clear;
  rays.tame &= clear;
  BlockedSearch<T> search(solid, rays);
  walk(solid, rays, search.reach, search);
  search.finish(found);
}

void blocked_floats(const PacketSolid<float>& solid, const RayPacket<float>& rays, float clearance,
                    PacketBlocked& found) {
  find_lanes(solid, rays, clearance, found);
}
void blocked_doubles(const PacketSolid<double>& solid, const RayPacket<double>& rays,
                     double clearance, PacketBlocked& found) {
  find_lanes(solid, rays, clearance, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tracer/packet_target.h"

namespace sir {

template <>
PacketBlocked find_blocked(const PacketSolid<float>& solid, const RayPacket<float>& rays,
                           float clearance) {
  PacketBlocked found;
  SIR_DISPATCH(blocked_floats)(solid, rays, clearance, found);
  return found;
}

template <>
PacketBlocked find_blocked(const PacketSolid<double>& solid, const RayPacket<double>& rays,
                           double clearance) {
  PacketBlocked found;
  SIR_DISPATCH(blocked_doubles)(solid, rays, clearance, found);
  return found;
}

}  // namespace sir
#endif
