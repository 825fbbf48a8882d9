// A packet made ready: what Classifier::set_pace() works out for one ray, and
// BoxProbe.
#if defined(SIR_TRACER_PACKET_RAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_RAY_INL_H_
#undef SIR_TRACER_PACKET_RAY_INL_H_
#else
#define SIR_TRACER_PACKET_RAY_INL_H_
#endif

#include <bit>

#include "tracer/packet_solid.h"
#include "tracer/packet_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

template <typename T>
struct ReadyPacket {
  using Word = typename Codes<T>::Word;
  static constexpr std::uint32_t kNoShape = RayStart<T>::kNowhere;

  alignas(64) T origin[3][kPacketLanes];
  alignas(64) T before[3][kPacketLanes];  ///< origin, and by so much boxes may miss it ...
  alignas(64) T beyond[3][kPacketLanes];  ///< ... on either side: see BoxProbe
  alignas(64) T paced[3][kPacketLanes];   ///< direction times pace
  alignas(64) T reciprocal[3][kPacketLanes];
  alignas(64) T pace[kPacketLanes];
  alignas(64) T speed[kPacketLanes];            ///< largest component of the direction
  alignas(64) T start_t[kPacketLanes];          ///< Classifier::start_t_
  alignas(64) T start_error[kPacketLanes];      ///< below 0: a free ray
  alignas(64) Word away_shape[kPacketLanes];    ///< stood on and left: never met again
  alignas(64) Word inward_shape[kPacketLanes];  ///< stood on and entered
  std::uint32_t still = 0;          ///< active lanes that have no direction: they meet nothing
  std::uint32_t wild = 0;           ///< active lanes for which T has too few digits
  std::uint32_t tame = 0;           ///< the other active ones
  std::uint32_t start_ends = 0;     ///< there are secondary rays
  T least_pace = 0, most_pace = 0;  ///< of the tame lanes
  bool descending[3] = {};          ///< most tame lanes go down along the axis

  /// `solid` may be null for free rays.
  ReadyPacket(const RayPacket<T>& packet, const PacketSolid<T>* solid);

 private:
  void ready_lanes(const RayPacket<T>& packet, const PacketSolid<T>* solid, std::size_t lane);
};

template <typename T>
HWY_INLINE Truths<T> finite(Numbers<T> a) {
  return abs(a) <= Numbers<T>(std::numeric_limits<T>::max());
}

// The pace of a speed is 2^-ilogb(speed): by the exponent's bits.
template <typename T>
HWY_INLINE Numbers<T> pace_of(Numbers<T> speed) {
  using Limits = std::numeric_limits<T>;
  using Word = hwy::MakeUnsigned<T>;
  constexpr hn::RebindToUnsigned<Chunk<T>> words;
  constexpr int kMantissa = Limits::digits - 1;
  constexpr Word kExponents = (static_cast<Word>(2 * Limits::max_exponent) - 1) << kMantissa;
  constexpr Word kTwiceBias = (static_cast<Word>(2 * Limits::max_exponent) - 2) << kMantissa;
  const auto exponent = hn::And(hn::BitCast(words, speed.v), hn::Set(words, kExponents));
  return {hn::BitCast(Chunk<T>(), hn::Sub(hn::Set(words, kTwiceBias), exponent))};
}

template <typename T>
HWY_INLINE void ReadyPacket<T>::ready_lanes(const RayPacket<T>& packet, const PacketSolid<T>* solid,
                                            std::size_t lane) {
  using V = Numbers<T>;
  using Limits = std::numeric_limits<T>;
  const Truths<T> active = truths_of<T>(packet.active >> lane);
  V o[3], d[3];
  for (int axis = 0; axis < 3; ++axis) {
    o[axis] = V::load(packet.origin[axis] + lane);
    d[axis] = V::load(packet.direction[axis] + lane);
  }
  const V fastest = max_of(max_of(abs(d[0]), abs(d[1])), abs(d[2]));
  const V far = max_of(max_of(abs(o[0]), abs(o[1])), abs(o[2]));
  const Truths<T> moving = (fastest > V(T(0))) & finite(fastest);
  const V factor = pace_of(fastest);
  Truths<T> fine = moving & (fastest >= V(Limits::min())) & (factor >= V(Limits::min())) &
                   (factor <= V(Limits::max()));
  const V error = V::load(start_error + lane);
  const Truths<T> starts = !(error < V(T(0)));
  const V widening = select(starts, error * V(solid ? solid->spread : T(0)), V(T(0)));
  fine &= widening <= V(solid ? solid->gap : T(0));
  for (int axis = 0; axis < 3; ++axis) {
    const V paced_d = d[axis] * factor;
    fine &= (d[axis] == V(T(0))) | (abs(paced_d) > V(Numeric<T>::kWellAboveUnderflow));
    fine &= finite(o[axis]);
    // Along an axis that the ray is parallel to, far enough not to matter.
    const V once = V(T(1)) / d[axis];
    const V most(Limits::max());
    const V bounded = lesser(greater(once, -most), most);
    o[axis].store(origin[axis] + lane);
    (o[axis] - widening).store(before[axis] + lane);
    (o[axis] + widening).store(beyond[axis] + lane);
    paced_d.store(paced[axis] + lane);
    bounded.store(reciprocal[axis] + lane);
  }
  factor.store(pace + lane);
  fastest.store(speed + lane);
  select(starts, far / fastest, V(T(0))).store(start_t + lane);
  still |= (active - moving).bits() << lane;
  wild |= ((active & moving) - fine).bits() << lane;
  tame |= (active & fine).bits() << lane;
}

template <typename T>
HWY_INLINE ReadyPacket<T>::ReadyPacket(const RayPacket<T>& packet, const PacketSolid<T>* solid) {
  std::uint32_t secondary = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane)
    secondary |= std::uint32_t{packet.start_leaf[lane] != RayStart<T>::kNowhere} << lane;
  secondary &= packet.active;
  start_ends = secondary;
  std::fill_n(start_error, kPacketLanes, T(-1));
  if (solid && secondary != 0) {
    for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
      const bool starts = secondary >> lane & 1u, inward = packet.inward >> lane & 1u;
      const std::uint32_t shape = starts ? solid->shapes[packet.start_leaf[lane]] : kNoShape;
      away_shape[lane] = inward ? kNoShape : shape;
      inward_shape[lane] = inward ? shape : kNoShape;
      if (starts) start_error[lane] = packet.start_error[lane];
    }
  }
  std::uint32_t down[3] = {};
  using V = Numbers<T>;
  V least(std::numeric_limits<T>::infinity()), most(T(0));
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    ready_lanes(packet, solid, lane);
    const Truths<T> tame_lanes = truths_of<T>(tame >> lane);
    const V own = V::load(pace + lane);
    least = select(tame_lanes, lesser(least, own), least);
    most = select(tame_lanes, greater(most, own), most);
    for (int axis = 0; axis < 3; ++axis)
      down[axis] |= (V::load(paced[axis] + lane) < V(T(0))).bits() << lane;
  }
  least_pace = hn::GetLane(hn::MinOfLanes(Chunk<T>(), least.v));
  most_pace = hn::GetLane(hn::MaxOfLanes(Chunk<T>(), most.v));
  for (int axis = 0; axis < 3; ++axis)
    descending[axis] = 2 * std::popcount(down[axis] & tame) > std::popcount(tame);
}

/// The lanes whose rays may meet a box at some t in [0, reach]; never fewer. And
/// where they enter it, 0 inside, to a few roundings.
template <typename T>
HWY_INLINE Truths<T> meets(const PacketBox<T>& box, const ReadyPacket<T>& rays, std::size_t lane,
                           Numbers<T> reach, Numbers<T>& enter) {
  using V = Numbers<T>;
  V leave = reach;
  enter = V(T(0));
  for (int axis = 0; axis < 3; ++axis) {
    const V r = V::load(rays.reciprocal[axis] + lane);
    const V a = (V(box.corner[0][axis]) - V::load(rays.beyond[axis] + lane)) * r;
    const V b = (V(box.corner[1][axis]) - V::load(rays.before[axis] + lane)) * r;
    enter = greater(enter, lesser(a, b));
    leave = lesser(leave, greater(a, b));
  }
  return enter <= leave * V(1 + 8 * Numeric<T>::kEpsilon);
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_RAY_INL_H_
