// The first change of state of one part behind the start of each ray.
#if defined(SIR_TRACER_PACKET_CHANGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_CHANGE_INL_H_
#undef SIR_TRACER_PACKET_CHANGE_INL_H_
#else
#define SIR_TRACER_PACKET_CHANGE_INL_H_
#endif

#include "tracer/packet_meet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

/// Lanes in neither `certain` nor `doubtful` have no change.
template <typename T>
struct Change {
  Truths<T> certain;
  Truths<T> doubtful;
  Truths<T> inside;  ///< certain, the start is inside the part: the change is the exit
  Numbers<T> t, error;
  Numbers<T> least;  ///< no change comes before this
  Codes<T> code;
};

/// The greatest enter or the least leave of several primitives.
template <typename T>
struct End {
  Numbers<T> t, error;
  Numbers<T> others;  ///< the nearest that another one may lie
  Codes<T> code;
};

/// Spans by which primitives take something away from a part.
template <typename T>
struct Carved {
  Numbers<T> enter, leave, enter_error, leave_error;
  Codes<T> enter_code, leave_code;
  Truths<T> met;
};

template <typename T>
class Changer {
  using V = Numbers<T>;
  using B = Truths<T>;
  static constexpr T kInfinity = std::numeric_limits<T>::infinity();
  static constexpr std::size_t kMostCarved = 24;

 public:
  HWY_INLINE Changer(const PacketSolid<T>& solid, const ReadyPacket<T>& rays, PacketCosts& costs)
      : solid_(solid), rays_(rays), costs_(costs) {}

  /// Of a part whose envelope the lanes of `where` enter at `box_enter`; what comes
  /// after `reach` does not matter.
  HWY_INLINE void find(const typename PacketSolid<T>::Part& part, std::size_t lane, B where,
                       V box_enter, V reach, Change<T>& change) {
    lane_ = lane;
    change.least = box_enter * V(1 - 16 * Numeric<T>::kEpsilon);
    if (part.positives == 1 && part.negatives == 0) find_alone(part, where, change);
    else find_carved(part, where, reach, change);
  }

 private:
  HWY_INLINE void look(std::uint32_t slot, B where, Met<T>& seen) {
    meet(solid_.leaves[slot], rays_, lane_, where, seen, costs_);
  }

  HWY_INLINE void find_alone(const typename PacketSolid<T>::Part& part, B where,
                             Change<T>& change) {
    Met<T> seen;
    look(part.first, where, seen);
    change.doubtful = seen.unsure;
    change.certain = B::none();
    if (!seen.met.any()) return;
    const B outside = seen.enter > seen.enter_error;
    change.inside = seen.met & (seen.enter < -seen.enter_error) & (seen.leave > seen.leave_error);
    const B thick = seen.leave - seen.enter >
                    seen.enter_error + seen.leave_error + V(solid_.chain) * seen.leave;
    change.certain = (seen.met & outside & thick) | change.inside;
    change.inside &= change.certain;
    change.doubtful |= seen.met - change.certain;
    change.t = select(change.inside, seen.leave, seen.enter);
    change.error = select(change.inside, seen.leave_error, seen.enter_error);
    change.code = select(change.inside, seen.leave_code(), seen.enter_code() | Codes<T>(kEntering));
    change.least =
        select(change.certain, change.t - change.error,
               greater(change.least, select(seen.met, seen.enter - seen.enter_error, V(T(0)))));
  }

  HWY_NOINLINE void find_carved(const typename PacketSolid<T>::Part& part, B where, V reach,
                                Change<T>& change);
  HWY_INLINE void carve(const typename PacketSolid<T>::Part& part, B where, B& vague);

  const PacketSolid<T>& solid_;
  const ReadyPacket<T>& rays_;
  PacketCosts& costs_;
  std::size_t lane_ = 0, count_ = 0;
  Carved<T> carved_[kMostCarved];
};

// What the negatives of a part cover.
template <typename T>
HWY_INLINE void Changer<T>::carve(const typename PacketSolid<T>::Part& part, B where, B& vague) {
  count_ = 0;
  for (std::uint32_t k = 0; k < part.negatives; ++k) {
    Met<T> seen;
    look(part.first + part.positives + k, where, seen);
    vague |= seen.unsure;
    if (!seen.met.any()) continue;
    if (count_ == kMostCarved) {
      vague |= seen.met;
      continue;
    }
    carved_[count_++] = {seen.enter,        seen.leave,        seen.enter_error, seen.leave_error,
                         seen.enter_code(), seen.leave_code(), seen.met};
  }
}

template <typename T>
HWY_NOINLINE void Changer<T>::find_carved(const typename PacketSolid<T>::Part& part, B where,
                                          V reach, Change<T>& change) {
  const V zero(T(0)), chain(solid_.chain);
  change.certain = change.doubtful = change.inside = B::none();
  B alive = where, vague = B::none();
  End<T> last_enter{V(-kInfinity), zero, V(-kInfinity), Codes<T>(0u)};
  End<T> first_leave{V(kInfinity), zero, V(kInfinity), Codes<T>(0u)};
  V surely_left(kInfinity);
  for (std::uint32_t k = 0; k < part.positives; ++k) {
    Met<T> seen;
    look(part.first + k, alive, seen);
    alive &= seen.met | seen.unsure;
    vague |= seen.unsure;
    if (!alive.any()) return;
    if (!seen.met.any()) continue;
    {
      End<T>& end = last_enter;
      const B better = seen.met & (seen.enter > end.t);
      const V other = select(better, end.t + end.error, seen.enter + seen.enter_error);
      end.others = select(seen.met, greater(end.others, other), end.others);
      end.t = select(better, seen.enter, end.t);
      end.error = select(better, seen.enter_error, end.error);
      end.code = select(better, seen.enter_code() | Codes<T>(kEntering), end.code);
    }
    {
      End<T>& end = first_leave;
      const B better = seen.met & (seen.leave < end.t);
      const V other = select(better, end.t - end.error, seen.leave - seen.leave_error);
      end.others = select(seen.met, lesser(end.others, other), end.others);
      end.t = select(better, seen.leave, end.t);
      end.error = select(better, seen.leave_error, end.error);
      end.code = select(better, seen.leave_code(), end.code);
    }
    surely_left = select(seen.met, lesser(surely_left, seen.leave + seen.leave_error), surely_left);
    change.least =
        select(seen.met, greater(change.least, seen.enter - seen.enter_error), change.least);
  }
  alive -= (change.least > surely_left) | (change.least > reach);
  if (!alive.any()) return;

  // Where the part begins: at the start, or at the last enter.
  const B outside = last_enter.t - last_enter.error > zero;
  const B within = (last_enter.t + last_enter.error < zero) & (last_enter.others < zero);
  vague |= !(outside | within);
  V from = select(outside, last_enter.t, zero),
    from_error = select(outside, last_enter.error, zero);
  V from_low = from - from_error;
  V from_high = select(outside, greater(from + from_error, last_enter.others), zero);
  Codes<T> from_code = last_enter.code;
  B named = from_low > last_enter.others + chain * from_high;
  B moved = B::none();
  carve(part, alive, vague);
  const B asked = alive - vague;
  // Moved on over what covers it.
  for (B again = asked; count_ > 0 && again.any();) {
    again = B::none();
    for (std::size_t k = 0; k < count_; ++k) {
      const Carved<T>& c = carved_[k];
      const B covers = asked & c.met & (c.enter + c.enter_error < from_low - chain * from_high) &
                       (c.leave - c.leave_error > from_high + chain * c.leave);
      if (!covers.any()) continue;
      from = select(covers, c.leave, from);
      from_error = select(covers, c.leave_error, from_error);
      from_low = select(covers, c.leave - c.leave_error, from_low);
      from_high = select(covers, c.leave + c.leave_error, from_high);
      from_code = select(covers, c.leave_code | Codes<T>(kEntering), from_code);
      named |= covers;
      moved |= covers;
      again |= covers;
    }
  }
  const B inside = within - moved;
  End<T> exit = first_leave;
  for (std::size_t k = 0; k < count_; ++k) {
    const Carved<T>& c = carved_[k];
    const B own = moved & ((c.leave_code | Codes<T>(kEntering)) == from_code);
    const B later = c.enter - c.enter_error > from_high + chain * c.enter;
    const B ended = c.leave + c.leave_error < from_low - chain * from_high;
    vague |= c.met - (own | later | ended);
    const B carves = inside & c.met & later;
    if (!carves.any()) continue;
    const B better = carves & (c.enter < exit.t);
    const V other = select(better, exit.t - exit.error, c.enter - c.enter_error);
    exit.others = select(carves, lesser(exit.others, other), exit.others);
    exit.t = select(better, c.enter, exit.t);
    exit.error = select(better, c.enter_error, exit.error);
    exit.code = select(better, c.enter_code, exit.code);
    const B thick = c.leave - c.enter > c.enter_error + c.leave_error + chain * c.leave;
    vague |= better - thick;
  }
  const V exit_low = lesser(exit.t - exit.error, exit.others);
  const V leave_low = lesser(first_leave.t - first_leave.error, first_leave.others);
  const B leaves =
      inside & (exit_low > zero) & (exit.t + exit.error + chain * exit.t < exit.others);
  const B absent = (from_low > surely_left) - (inside | vague);
  const B enters = (named & (leave_low > from_high + chain * first_leave.t)) - inside;
  alive -= absent;
  change.inside = (alive & leaves) - vague;
  change.certain = change.inside | ((alive & enters) - vague);
  change.doubtful = alive - change.certain;
  change.t = select(change.inside, exit.t, from);
  change.error = select(change.inside, exit.error, from_error);
  change.code = select(change.inside, exit.code, from_code);
  change.least = select(change.certain, change.t - change.error, change.least);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_CHANGE_INL_H_
