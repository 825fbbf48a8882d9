#include "tracer/packet_hit.h"

#include <bit>

#include "tracer/ray_secondary.h"
#include "tracer/shade.h"
#include "tracer/surface_point.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/packet_hit.cpp"  // NOLINT
#include <hwy/foreach_target.h>

#include "tracer/packet_vector-inl.h"

// The scalar functions stand beside what they do here; every operation is theirs, in
// their order. Lanes whose squares overflow or underflow are left to them.
HWY_BEFORE_NAMESPACE();
namespace sir {
namespace HWY_NAMESPACE {

template <typename T>
struct Vectors {
  Numbers<T> x, y, z;

  static HWY_INLINE Vectors load(const T (&from)[3][kPacketLanes], std::size_t lane) {
    return {Numbers<T>::load(from[0] + lane), Numbers<T>::load(from[1] + lane),
            Numbers<T>::load(from[2] + lane)};
  }
  static HWY_INLINE Vectors of(const glm::vec<3, T>& v) { return {v.x, v.y, v.z}; }

  HWY_INLINE void store(Truths<T> where, T (&to)[3][kPacketLanes], std::size_t lane) const {
    hn::BlendedStore(x.v, where.m, Chunk<T>(), to[0] + lane);
    hn::BlendedStore(y.v, where.m, Chunk<T>(), to[1] + lane);
    hn::BlendedStore(z.v, where.m, Chunk<T>(), to[2] + lane);
  }

  friend HWY_INLINE Vectors operator+(Vectors a, Vectors b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend HWY_INLINE Vectors operator-(Vectors a, Vectors b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend HWY_INLINE Vectors operator*(Vectors a, Numbers<T> f) {
    return {a.x * f, a.y * f, a.z * f};
  }
  friend HWY_INLINE Vectors operator/(Vectors a, Vectors b) {
    return {a.x / b.x, a.y / b.y, a.z / b.z};
  }
};

template <typename T>
HWY_INLINE Numbers<T> dot(Vectors<T> a, Vectors<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename T>
HWY_INLINE Numbers<T> largest(Vectors<T> a) {
  return greater(greater(abs(a.x), abs(a.y)), abs(a.z));
}

template <typename T>
HWY_INLINE Vectors<T> select(Truths<T> condition, Vectors<T> yes, Vectors<T> no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}

// m v, and v m.
template <typename T>
HWY_INLINE Vectors<T> times(const glm::mat<3, 3, T>& m, Vectors<T> v) {
  using V = Numbers<T>;
  return {V(m[0][0]) * v.x + V(m[1][0]) * v.y + V(m[2][0]) * v.z,
          V(m[0][1]) * v.x + V(m[1][1]) * v.y + V(m[2][1]) * v.z,
          V(m[0][2]) * v.x + V(m[1][2]) * v.y + V(m[2][2]) * v.z};
}
template <typename T>
HWY_INLINE Vectors<T> times(Vectors<T> v, const glm::mat<3, 3, T>& m) {
  using V = Numbers<T>;
  return {V(m[0][0]) * v.x + V(m[0][1]) * v.y + V(m[0][2]) * v.z,
          V(m[1][0]) * v.x + V(m[1][1]) * v.y + V(m[1][2]) * v.z,
          V(m[2][0]) * v.x + V(m[2][1]) * v.y + V(m[2][2]) * v.z};
}

// well_sized().
template <typename T>
HWY_INLINE Truths<T> well_sized_lanes(Numbers<T> square) {
  using Limits = std::numeric_limits<T>;
  constexpr T kLeast = Limits::min() / (Limits::epsilon() * Limits::epsilon());
  return (square >= Numbers<T>(kLeast)) & (square <= Numbers<T>(Limits::max()));
}

// normalize(); `fine` loses the lanes that it cannot do.
template <typename T>
HWY_INLINE Vectors<T> unit(Vectors<T> a, Truths<T>& fine) {
  const Numbers<T> square = dot(a, a);
  fine &= well_sized_lanes(square);
  return a * (Numbers<T>(T(1)) / sqrt(square));
}

// outward_normal(). Hypotenuses are the library's, lane by lane.
template <typename T>
HWY_INLINE Vectors<T> outward(PrimitiveKind kind, int face, Truths<T> where, Vectors<T> p) {
  using V = Numbers<T>;
  const V zero(T(0)), one(T(1));
  const auto along = [&](int axis, T sign) {
    return Vectors<T>{axis == 0 ? V(sign) : zero, axis == 1 ? V(sign) : zero,
                      axis == 2 ? V(sign) : zero};
  };
  switch (kind) {
    case PrimitiveKind::cube: return along(face / 2, face % 2 == 0 ? T(-1) : T(1));
    case PrimitiveKind::sphere: return p;
    case PrimitiveKind::cylinder:
      if (face == 2) return {p.x, zero, p.z};
      return along(1, face == 1 ? T(1) : T(-1));
    case PrimitiveKind::cone: break;
  }
  if (face != 0) return along(1, T(-1));
  alignas(64) T x[kPacketLanes], z[kPacketLanes], radius[kPacketLanes] = {};
  p.x.store(x);
  p.z.store(z);
  for (std::uint32_t left = where.bits(); left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    radius[lane] = std::hypot(x[lane], z[lane]);
  }
  const V r = V::load(radius);
  return select(r > zero, Vectors<T>{p.x, r, p.z}, along(1, T(1)));
}

template <typename T>
HWY_INLINE void hits_of_leaf(const Leaf<T>& leaf, int face, Truths<T> where, Vectors<T> point,
                             Vectors<T>& normal, PacketHits<T>& hits, std::size_t lane) {
  const auto& to = leaf.placement;
  const auto divisors = Vectors<T>::of(to.divisors);
  const Vectors<T> local = times(to.numerators, point - Vectors<T>::of(to.translation)) / divisors;
  local.store(where, hits.local, lane);
  const Vectors<T> n = times(outward(leaf.kind, face, where, local) / divisors, to.numerators);
  normal = select(where, n, normal);
}

template <typename T>
HWY_INLINE void hits_of(const Model<T>& model, const RayPacket<T>& rays, std::uint32_t lanes,
                        const Boundary<T> (&boundaries)[kPacketLanes], PacketHits<T>& hits) {
  using V = Numbers<T>;
  alignas(64) T t[kPacketLanes] = {}, t_error[kPacketLanes] = {};
  alignas(64) typename Codes<T>::Word code[kPacketLanes] = {};
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    t[lane] = boundaries[lane].t;
    t_error[lane] = boundaries[lane].error;
    code[lane] = boundaries[lane].leaf << 3 | boundaries[lane].face;
  }
  std::uint32_t unfit = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    const Truths<T> where = truths_of<T>(lanes >> lane);
    if (!where.any()) continue;
    const auto origin = Vectors<T>::load(rays.origin, lane);
    const auto direction = Vectors<T>::load(rays.direction, lane);
    const V at = V::load(t + lane);
    const Vectors<T> point = origin + direction * at;
    Truths<T> fine = where;
    const Vectors<T> incident = unit(direction, fine);
    Vectors<T> normal = point;
    const auto codes = Codes<T>::load(code + lane);
    for (Truths<T> left = where; left.any();) {
      const auto one = static_cast<std::uint32_t>(
          code[lane + static_cast<std::size_t>(std::countr_zero(left.bits()))]);
      const Truths<T> same = left & (codes == Codes<T>(one));
      hits_of_leaf(model.solid.leaves[one >> 3], static_cast<int>(one & 7u), same, point, normal,
                   hits, lane);
      left -= same;
    }
    normal = unit(normal, fine);
    const Truths<T> behind = dot(normal, incident) > V(T(0));
    normal = {select(behind, -normal.x, normal.x), select(behind, -normal.y, normal.y),
              select(behind, -normal.z, normal.z)};
    const V speed = largest(direction);
    const V error =
        V(Numeric<T>::kStartRoundings * Numeric<T>::kEpsilon) * (largest(origin) + at * speed) +
        V::load(t_error + lane) * speed;
    point.store(where, hits.point, lane);
    incident.store(where, hits.incident, lane);
    normal.store(where, hits.normal, lane);
    hn::BlendedStore(error.v, where.m, Chunk<T>(), hits.error + lane);
    unfit |= (where - fine).bits() << lane;
  }
  for (; unfit != 0; unfit &= unfit - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(unfit));
    const Hit<T> hit = hit_at(model, rays.ray(lane), boundaries[lane]);
    for (int axis = 0; axis < 3; ++axis) {
      hits.incident[axis][lane] = hit.incident.v[axis];
      hits.normal[axis][lane] = hit.normal.v[axis];
    }
  }
}

template <typename T>
HWY_INLINE void incidence_of(const PacketHits<T>& hits, std::uint32_t lanes, PointCena<T> light,
                             bool with_gleam, PacketIncidence<T>& incidence) {
  using V = Numbers<T>;
  const V zero(T(0)), one(T(1));
  const auto source = Vectors<T>::of(light.v);
  std::uint32_t unfit = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    const Truths<T> where = truths_of<T>(lanes >> lane);
    if (!where.any()) continue;
    const auto normal = Vectors<T>::load(hits.normal, lane);
    const Vectors<T> to_light = source - Vectors<T>::load(hits.point, lane);
    const V square = dot(to_light, to_light), distance = sqrt(square);
    const V cosine = dot(normal, to_light) / distance;
    to_light.store(where, incidence.to_light, lane);
    distance.store(incidence.distance + lane);
    cosine.store(incidence.cosine + lane);
    Truths<T> fine = well_sized_lanes(square);
    if (with_gleam) {
      const Vectors<T> half = to_light * (one / distance) - Vectors<T>::load(hits.incident, lane);
      const V half_square = dot(half, half);
      // Where it is not lit the gleam is not asked for.
      fine &= well_sized_lanes(half_square) | !(cosine > zero);
      const V gleam = dot(normal, half) / sqrt(half_square);
      lesser(one, greater(zero, gleam)).store(incidence.gleam + lane);
    }
    unfit |= (where - fine).bits() << lane;
  }
  for (; unfit != 0; unfit &= unfit - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(unfit));
    const Incidence<T> one_by_one(hits.point_of(lane), hits.normal_of(lane), light);
    for (int axis = 0; axis < 3; ++axis)
      incidence.to_light[axis][lane] = one_by_one.to_light.v[axis];
    incidence.distance[lane] = one_by_one.distance;
    incidence.cosine[lane] = one_by_one.cosine;
    incidence.gleam[lane] =
        with_gleam ? gleam_of(-hits.incident_of(lane), hits.normal_of(lane), one_by_one) : T(0);
  }
}

template <typename T>
HWY_INLINE void mirrored_of(const PacketHits<T>& hits, std::uint32_t lanes,
                            T (&directions)[3][kPacketLanes]) {
  std::uint32_t unfit = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    const Truths<T> where = truths_of<T>(lanes >> lane);
    if (!where.any()) continue;
    const auto normal = Vectors<T>::load(hits.normal, lane);
    const auto incident = Vectors<T>::load(hits.incident, lane);
    Truths<T> fine = where;
    const auto direction =
        unit(incident - normal * (Numbers<T>(T(2)) * dot(normal, incident)), fine);
    direction.store(where, directions, lane);
    unfit |= (where - fine).bits() << lane;
  }
  for (; unfit != 0; unfit &= unfit - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(unfit));
    const auto direction = mirrored(hits.incident_of(lane), hits.normal_of(lane));
    for (int axis = 0; axis < 3; ++axis) directions[axis][lane] = direction.v[axis];
  }
}

template <typename T>
HWY_INLINE std::uint32_t refracted_of(const PacketHits<T>& hits, std::uint32_t lanes,
                                      const T (&n1)[kPacketLanes], const T (&n2)[kPacketLanes],
                                      T (&directions)[3][kPacketLanes]) {
  using V = Numbers<T>;
  const V zero(T(0)), one(T(1));
  std::uint32_t unfit = 0, found = 0;
  for (std::size_t lane = 0; lane < kPacketLanes; lane += hn::MaxLanes(Chunk<T>())) {
    const Truths<T> where = truths_of<T>(lanes >> lane);
    if (!where.any()) continue;
    const auto normal = Vectors<T>::load(hits.normal, lane);
    const auto incident = Vectors<T>::load(hits.incident, lane);
    const V from = V::load(n1 + lane), to = V::load(n2 + lane);
    const V cosine = max_of(zero, -dot(normal, incident));
    const Vectors<T> tangent = incident + normal * cosine;
    const V eta = from / to, sines = dot(tangent, tangent), sine = eta * sqrt(sines);
    const V square = (one - sine) * (one + sine);
    const Truths<T> straight = where & (from == to);
    Truths<T> fine = where & well_sized_lanes(sines);
    const Truths<T> through = !(square < zero);
    Truths<T> unit_fine = where;
    const Vectors<T> bent = unit(tangent * eta - normal * sqrt(square), unit_fine);
    fine &= unit_fine | !through;
    fine |= straight;
    select(straight, incident, bent).store(where, directions, lane);
    found |= (where & fine & (straight | through)).bits() << lane;
    unfit |= (where - fine).bits() << lane;
  }
  for (; unfit != 0; unfit &= unfit - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(unfit));
    VectorCena<T> direction;
    if (!refracted(hits.incident_of(lane), hits.normal_of(lane), n1[lane], n2[lane], direction))
      continue;
    found |= 1u << lane;
    for (int axis = 0; axis < 3; ++axis) directions[axis][lane] = direction.v[axis];
  }
  return found;
}

// One set of names for each scalar type: the dispatch tables cannot hold templates.
#define SIR_LANES(T, suffix)                                                                  \
  void hits_##suffix(const Model<T>& model, const RayPacket<T>& rays, std::uint32_t where,    \
                     const Boundary<T>(&boundaries)[kPacketLanes], PacketHits<T>& hits) {     \
    hits_of(model, rays, where, boundaries, hits);                                            \
  }                                                                                           \
  void incidence_##suffix(const PacketHits<T>& hits, std::uint32_t where, PointCena<T> light, \
                          bool with_gleam, PacketIncidence<T>& incidence) {                   \
    incidence_of(hits, where, light, with_gleam, incidence);                                  \
  }                                                                                           \
  void mirrored_##suffix(const PacketHits<T>& hits, std::uint32_t where,                      \
                         T(&directions)[3][kPacketLanes]) {                                   \
    mirrored_of(hits, where, directions);                                                     \
  }                                                                                           \
  std::uint32_t refracted_##suffix(const PacketHits<T>& hits, std::uint32_t where,            \
                                   const T(&n1)[kPacketLanes], const T(&n2)[kPacketLanes],    \
                                   T(&directions)[3][kPacketLanes]) {                         \
    return refracted_of(hits, where, n1, n2, directions);                                     \
  }
SIR_LANES(float, floats)
SIR_LANES(double, doubles)
#undef SIR_LANES

}  // namespace HWY_NAMESPACE
}  // namespace sir
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tracer/packet_target.h"

namespace sir {

#define SIR_LANES_OF(T, suffix)                                                           \
  template <>                                                                             \
  void find_hits(const Model<T>& model, const RayPacket<T>& rays, std::uint32_t where,    \
                 const Boundary<T>(&boundaries)[kPacketLanes], PacketHits<T>& hits) {     \
    SIR_DISPATCH(hits_##suffix)(model, rays, where, boundaries, hits);                    \
  }                                                                                       \
  template <>                                                                             \
  void find_incidence(const PacketHits<T>& hits, std::uint32_t where, PointCena<T> light, \
                      bool with_gleam, PacketIncidence<T>& incidence) {                   \
    SIR_DISPATCH(incidence_##suffix)(hits, where, light, with_gleam, incidence);          \
  }                                                                                       \
  template <>                                                                             \
  void find_mirrored(const PacketHits<T>& hits, std::uint32_t where,                      \
                     T(&mirrored)[3][kPacketLanes]) {                                     \
    SIR_DISPATCH(mirrored_##suffix)(hits, where, mirrored);                               \
  }                                                                                       \
  template <>                                                                             \
  std::uint32_t find_refracted(const PacketHits<T>& hits, std::uint32_t where,            \
                               const T(&n1)[kPacketLanes], const T(&n2)[kPacketLanes],    \
                               T(&refracted)[3][kPacketLanes]) {                          \
    return SIR_DISPATCH(refracted_##suffix)(hits, where, n1, n2, refracted);              \
  }
SIR_LANES_OF(float, floats)
SIR_LANES_OF(double, doubles)
#undef SIR_LANES_OF

}  // namespace sir
#endif
