// Points where the rays of a packet meet the solid (ARV_INTER, thesis 3.3), and how
// light falls on them: hit_at() and Incidence for sixteen rays at once.
#pragma once

#include "tracer/hit.h"
#include "tracer/packet.h"

namespace sir {

/// Hit, component by component: component[axis][lane].
template <typename T>
struct PacketHits {
  alignas(64) T point[3][kPacketLanes];
  alignas(64) T incident[3][kPacketLanes];  ///< unit, along the ray; E is its opposite
  alignas(64) T normal[3][kPacketLanes];    ///< unit, on E's side
  alignas(64) T local[3][kPacketLanes];     ///< the point in SC_LOCAL of its primitive
  alignas(64) T error[kPacketLanes];        ///< as Hit::error

  PointCena<T> point_of(std::size_t lane) const {
    return {{point[0][lane], point[1][lane], point[2][lane]}};
  }
  PointLocal<T> local_of(std::size_t lane) const {
    return {{local[0][lane], local[1][lane], local[2][lane]}};
  }
  VectorCena<T> incident_of(std::size_t lane) const {
    return {{incident[0][lane], incident[1][lane], incident[2][lane]}};
  }
  VectorCena<T> normal_of(std::size_t lane) const {
    return {{normal[0][lane], normal[1][lane], normal[2][lane]}};
  }
};

/// What hit_at() gives for the lanes' boundaries, to the last bit. Only the lanes of
/// `where` are written.
template <typename T>
void find_hits(const Model<T>& model, const RayPacket<T>& rays, std::uint32_t where,
               const Boundary<T> (&boundaries)[kPacketLanes], PacketHits<T>& hits);

/// How a light's rays fall on a packet's hits.
template <typename T>
struct PacketIncidence {
  alignas(64) T to_light[3][kPacketLanes];  ///< light - point
  alignas(64) T distance[kPacketLanes];     ///< of to_light
  alignas(64) T cosine[kPacketLanes];       ///< N.L
  alignas(64) T gleam[kPacketLanes];        ///< N.H within [0,1], if it was asked for

  VectorCena<T> to_light_of(std::size_t lane) const {
    return {{to_light[0][lane], to_light[1][lane], to_light[2][lane]}};
  }
};

/// What Incidence and gleam_of() give for the lanes of `where`, to the last bit.
template <typename T>
void find_incidence(const PacketHits<T>& hits, std::uint32_t where, PointCena<T> light,
                    bool with_gleam, PacketIncidence<T>& incidence);

/// What mirrored() gives for the lanes of `where`, to the last bit.
template <typename T>
void find_mirrored(const PacketHits<T>& hits, std::uint32_t where, T (&mirrored)[3][kPacketLanes]);

/// What refracted() gives for the lanes of `where`, to the last bit: those in the
/// result have a direction. From index n1 into n2.
template <typename T>
std::uint32_t find_refracted(const PacketHits<T>& hits, std::uint32_t where,
                             const T (&n1)[kPacketLanes], const T (&n2)[kPacketLanes],
                             T (&refracted)[3][kPacketLanes]);

}  // namespace sir
