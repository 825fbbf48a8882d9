// Our side of the comparison with Embree: many rays' nearest boundaries, one thread, as the
// renderer finds those of primary rays (render.cpp, wavefront.cpp).
#pragma once

#include <limits>
#include <vector>

#include "tracer/model.h"
#include "tracer/packets.h"
#include "tracer/ray_stream.h"

namespace sir::bench {

/// Where no boundary is.
template <typename T>
inline constexpr T kNothing = std::numeric_limits<T>::infinity();

/// Pixels along the sides of what the renderer traces in one go, and of a packet.
inline constexpr int kBatchSide = 16, kPacketSide = 4;

/// The primary rays of a square image, `side` a multiple of kBatchSide, in the renderer's order:
/// batch after batch, in each square after square of sixteen rays.
template <typename T>
std::vector<RayCena<T>> primary_rays(const Model<T>& model, int side);

/// The renderer's own way to the first boundaries; one for each thread. The model must outlive
/// it and have its solid laid out for packets.
template <typename T>
class FirstHits {
 public:
  explicit FirstHits(const Model<T>& model);

  /// t of the first boundary of each ray, or kNothing; rays as primary_rays() gives them. A
  /// batch is filled into packets, its tile list gathered, the packets sent, and what they leave
  /// in doubt asked of the Classifier.
  void find(const std::vector<RayCena<T>>& rays, std::vector<T>& t);

  RayCounts counts() const { return packets_.counts(); }

 private:
  Packets<T> packets_;
  RayStream<T> stream_;
  PartList<T> list_;
};

}  // namespace sir::bench
