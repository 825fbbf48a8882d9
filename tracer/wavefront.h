// TRACE for many pixels at once (thesis 2.4.1, 3.3): all rays of one depth, then all
// of the next, so that those of a kind can be traced together.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "tracer/packet_hit.h"
#include "tracer/packets.h"
#include "tracer/ray_stream.h"
#include "tracer/trace.h"

namespace sir {

/// Gives the bytes that Tracer::pixel() gives, by packets; one for each thread. The
/// model must outlive it, and have its solid laid out. T: float or double.
template <typename T>
class Wavefront {
 public:
  Wavefront(const Model<T>& model, const TraceOptions& options);

  /// The bytes of primary rays, as many as there are places in `bytes`. Neighbours
  /// are faster than strangers.
  void pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes);

  RayCounts counts() const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr int kBreadth = 7;  // depths that are taken together; trees grow as 2^depth

  // What a ray is sent for.
  struct Sender {
    T index;  // of its medium; 0: not known
    T path_weight;
    std::uint32_t parent, pixel;  // index into nodes_, or kNone; into colours_
    bool mirror;                  // of its parent's two
  };
  // A point that is seen, until all that it sends on has come back.
  struct Node {
    Colour<T> own, mirrored, passed;  // its light, and what secondary rays saw times weights
    T mirror_weight, through_weight;
    std::uint32_t parent, pixel;
    bool mirror;
  };
  // What is needed besides while its own depth is worked on.
  struct Detail {
    const Reflectance<T>* reflectance;
    T path_weight, index, index_beyond;
    std::uint32_t leaf;
    bool leaf_entering, has_through;
  };
  struct Asked {
    std::uint32_t node;
    T cosine, gleam;
  };

  // The nodes from first_ on are those of the depth that is worked on, in the order of
  // hits_ and their lanes.
  template <typename Visit>
  void for_each_hit(Visit&& visit);  // visit(node, packet, lane)
  const Detail& detail(std::uint32_t node) const { return details_[node - first_]; }
  RayStart<T> leaving(std::uint32_t node, T error, bool through) const;

  void find_points(int depth);
  void miss(const Sender& sender);
  std::uint32_t add_nodes(std::size_t p, const PacketFirst<T>& found);
  void refract(std::size_t p, std::uint32_t asking, std::uint32_t node);
  void come_to(std::uint32_t pixel, const Colour<T>& colour);
  bool spares(std::uint32_t node, const Colour<T>& most, const PointLight<T>* from, int depth);
  bool decided(std::uint32_t node, const PointLight<T>* from, int depth);
  T slack(int depth) const;
  void ask_light(const PointLight<T>& source, int depth);
  void ask(std::uint32_t node, const PointLight<T>& source, const PacketHits<T>& hits,
           const PacketIncidence<T>& incidence, std::size_t lane, int depth);
  void hear_light(const PointLight<T>& source);
  std::uint32_t met_before_light(const RayPacket<T>& rays);
  void hear_through_glass(const RayPacket<T>& rays, const PointLight<T>& source,
                          Colour<T> (&arriving)[kPacketLanes]);
  std::uint32_t hear_filters(const RayPacket<T>& rays, std::uint32_t where,
                             const PointLight<T>& source, Colour<T> (&arriving)[kPacketLanes]);
  T transmission_at(const RayPacket<T>& rays, std::size_t lane, std::uint32_t leaf,
                    std::uint8_t face, T t) const;
  void light_up(const Asked& asked, const Colour<T>& arriving);
  void branch(int depth);
  void branch_off(std::uint32_t node, bool mirror, int depth, const RayCena<T>& ray, T error);
  void finish_deep(int depth);
  void deliver(std::uint32_t parent, std::uint32_t pixel, bool mirror, const Colour<T>& colour);
  Colour<T> most_of_branch(std::uint32_t node, bool mirror, int depth) const;
  bool wanted(std::uint32_t node, T weight) const;

  const Model<T>& model_;
  TraceOptions options_;
  Packets<T> packets_;
  Tracer<T> deep_;  // beyond kBreadth
  RadianceBound<T> bound_;
  bool sparing_;                        // rays that cannot change a byte are not cast
  std::vector<Colour<T>> lights_from_;  // the intensities of a light and all after it
  RayCounts counts_;
  RayStream<T> rays_, next_, shadow_;
  PartList<T> list_;                            // of the primary rays
  std::vector<Sender> senders_, next_senders_;  // of the rays, in their order
  std::vector<PacketHits<T>> hits_;
  std::vector<std::uint32_t> hit_lanes_;  // of hits_
  std::vector<Node> nodes_;               // of all depths, in order
  std::uint32_t first_ = 0;
  std::vector<Detail> details_;
  std::vector<Asked> asked_;        // for each shadow ray
  std::vector<Colour<T>> colours_;  // of the pixels, when all is done
  std::vector<Colour<T>> come_;     // what has come to them so far, if sparing_
  struct Directions {
    alignas(64) T component[3][kPacketLanes];
    VectorCena<T> of(std::size_t lane) const {
      return {{component[0][lane], component[1][lane], component[2][lane]}};
    }
  };
  std::vector<Directions> through_;  // refracted, of hits_
};

// What is asked of every ray stands here, to be compiled in place.

template <typename T>
template <typename Visit>
void Wavefront<T>::for_each_hit(Visit&& visit) {
  std::uint32_t node = first_;
  for (std::size_t p = 0; p < hit_lanes_.size(); ++p)
    for (std::uint32_t left = hit_lanes_[p]; left != 0; left &= left - 1)
      visit(node++, p, static_cast<std::size_t>(std::countr_zero(left)));
}

template <typename T>
inline bool Wavefront<T>::wanted(std::uint32_t node, T weight) const {
  if (!(weight > 0)) return model_.effects.exhaustive;
  return detail(node).path_weight * weight >= static_cast<T>(options_.cutoff);
}

// The most that the pixel may get from the mirrored or the refracted ray.
template <typename T>
inline Colour<T> Wavefront<T>::most_of_branch(std::uint32_t node, bool mirror, int depth) const {
  const T weight = mirror ? nodes_[node].mirror_weight : nodes_[node].through_weight;
  if (!(weight > 0)) return Colour<T>(0);
  const T path_weight = detail(node).path_weight;
  if (depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::zero) return Colour<T>(0);
    return path_weight * weight * model_.background;
  }
  if (!wanted(node, weight)) return Colour<T>(0);
  return path_weight * weight * bound_.at(depth + 1);
}

template <typename T>
inline RayStart<T> Wavefront<T>::leaving(std::uint32_t node, T error, bool through) const {
  const Detail& detail = this->detail(node);
  return {detail.leaf, detail.leaf_entering == through, error};
}

// Whether a ray of the node that brings at most `most` need not be cast.
template <typename T>
inline bool Wavefront<T>::spares(std::uint32_t node, const Colour<T>& most,
                                 const PointLight<T>* from, int depth) {
  return !level_to_come(come_[nodes_[node].pixel], most) && decided(node, from, depth);
}

template <typename T>
inline void Wavefront<T>::come_to(std::uint32_t pixel, const Colour<T>& colour) {
  if (sparing_) come_[pixel] += colour;
}

}  // namespace sir
