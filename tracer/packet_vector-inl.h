// Vectors that read like numbers, over Highway, so that the packets' formulas can be
// held against the scalar ones line by line. Nothing is contracted or reordered.
//
// An -inl header is compiled once for each instruction set and cannot say
// `#pragma once`.
#if defined(SIR_TRACER_PACKET_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SIR_TRACER_PACKET_VECTOR_INL_H_
#undef SIR_TRACER_PACKET_VECTOR_INL_H_
#else
#define SIR_TRACER_PACKET_VECTOR_INL_H_
#endif

#include <hwy/highway.h>

#include "tracer/packet.h"

HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many lanes of a packet as the hardware's vector holds; one without vectors.
template <typename T>
using Chunk = hn::CappedTag<T, kPacketLanes>;

/// One truth for each lane.
template <typename T>
struct Truths {
  using Native = hn::Mask<Chunk<T>>;
  Native m;

  static HWY_INLINE Truths none() { return {hn::MaskFromVec(hn::Zero(Chunk<T>()))}; }
  HWY_INLINE bool any() const { return !hn::AllFalse(Chunk<T>(), m); }
  HWY_INLINE std::uint32_t bits() const {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Chunk<T>(), m, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
  }
  HWY_INLINE std::size_t count() const { return hn::CountTrue(Chunk<T>(), m); }

  friend HWY_INLINE Truths operator&(Truths a, Truths b) { return {hn::And(a.m, b.m)}; }
  friend HWY_INLINE Truths operator|(Truths a, Truths b) { return {hn::Or(a.m, b.m)}; }
  friend HWY_INLINE Truths operator!(Truths a) { return {hn::Not(a.m)}; }
  HWY_INLINE Truths& operator&=(Truths b) { return *this = *this & b; }
  HWY_INLINE Truths& operator|=(Truths b) { return *this = *this | b; }
  /// a and not b.
  friend HWY_INLINE Truths operator-(Truths a, Truths b) { return {hn::AndNot(b.m, a.m)}; }
  HWY_INLINE Truths& operator-=(Truths b) { return *this = *this - b; }
};

/// One number for each lane.
template <typename T>
struct Numbers {
  using Native = hn::Vec<Chunk<T>>;
  Native v;

  Numbers() = default;
  HWY_INLINE Numbers(Native native) : v(native) {}  // NOLINT: a number is one
  HWY_INLINE Numbers(T everywhere) : v(hn::Set(Chunk<T>(), everywhere)) {}  // NOLINT

  static HWY_INLINE Numbers load(const T* from) { return {hn::Load(Chunk<T>(), from)}; }
  HWY_INLINE void store(T* to) const { hn::Store(v, Chunk<T>(), to); }

  friend HWY_INLINE Numbers operator+(Numbers a, Numbers b) { return {hn::Add(a.v, b.v)}; }
  friend HWY_INLINE Numbers operator-(Numbers a, Numbers b) { return {hn::Sub(a.v, b.v)}; }
  friend HWY_INLINE Numbers operator*(Numbers a, Numbers b) { return {hn::Mul(a.v, b.v)}; }
  friend HWY_INLINE Numbers operator/(Numbers a, Numbers b) { return {hn::Div(a.v, b.v)}; }
  friend HWY_INLINE Numbers operator-(Numbers a) { return {hn::Neg(a.v)}; }

  friend HWY_INLINE Truths<T> operator<(Numbers a, Numbers b) { return {hn::Lt(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator>(Numbers a, Numbers b) { return {hn::Gt(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator<=(Numbers a, Numbers b) { return {hn::Le(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator>=(Numbers a, Numbers b) { return {hn::Ge(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator==(Numbers a, Numbers b) { return {hn::Eq(a.v, b.v)}; }
};

template <typename T>
HWY_INLINE Numbers<T> abs(Numbers<T> a) {
  return {hn::Abs(a.v)};
}
template <typename T>
HWY_INLINE Numbers<T> sqrt(Numbers<T> a) {
  return {hn::Sqrt(a.v)};
}
template <typename T>
HWY_INLINE Numbers<T> select(Truths<T> condition, Numbers<T> yes, Numbers<T> no) {
  return {hn::IfThenElse(condition.m, yes.v, no.v)};
}

/// std::max and std::min, with what they make of a NaN.
template <typename T>
HWY_INLINE Numbers<T> max_of(Numbers<T> a, Numbers<T> b) {
  return select(a < b, b, a);
}
template <typename T>
HWY_INLINE Numbers<T> min_of(Numbers<T> a, Numbers<T> b) {
  return select(b < a, b, a);
}
/// The same where neither is a NaN, whichever of two zeros.
template <typename T>
HWY_INLINE Numbers<T> greater(Numbers<T> a, Numbers<T> b) {
  return {hn::Max(a.v, b.v)};
}
template <typename T>
HWY_INLINE Numbers<T> lesser(Numbers<T> a, Numbers<T> b) {
  return {hn::Min(a.v, b.v)};
}

/// One whole number for each lane, as wide as a T.
template <typename T>
struct Codes {
  using Word = hwy::MakeUnsigned<T>;
  using Tag = hn::RebindToUnsigned<Chunk<T>>;
  using Native = hn::Vec<Tag>;
  Native v;

  Codes() = default;
  HWY_INLINE Codes(Native native) : v(native) {}                                 // NOLINT
  HWY_INLINE Codes(std::uint32_t everywhere) : v(hn::Set(Tag(), everywhere)) {}  // NOLINT
  static HWY_INLINE Codes load(const Word* from) { return {hn::Load(Tag(), from)}; }
  HWY_INLINE void store(Word* to) const { hn::Store(v, Tag(), to); }

  friend HWY_INLINE Codes operator|(Codes a, Codes b) { return {hn::Or(a.v, b.v)}; }
  friend HWY_INLINE Codes operator&(Codes a, Codes b) { return {hn::And(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator==(Codes a, Codes b) {
    return {hn::RebindMask(Chunk<T>(), hn::Eq(a.v, b.v))};
  }
};
template <typename T>
HWY_INLINE Codes<T> select(Truths<T> condition, Codes<T> yes, Codes<T> no) {
  return {hn::IfThenElse(hn::RebindMask(typename Codes<T>::Tag(), condition.m), yes.v, no.v)};
}

/// The lanes of a chunk, from a packet's bits.
template <typename T>
HWY_INLINE Truths<T> truths_of(std::uint32_t bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8)};
  return {hn::LoadMaskBits(Chunk<T>(), bytes)};
}

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#endif  // SIR_TRACER_PACKET_VECTOR_INL_H_
