// TRACE for many pixels at once (thesis 2.4.1, 3.3): all rays of one depth, then all
// of the next, so that those of a kind can be traced together.
#pragma once

#include <span>
#include <vector>

#include "tracer/packets.h"
#include "tracer/shade.h"
#include "tracer/trace.h"

namespace sir {

/// Gives the bytes that Tracer::pixel() gives; one for each thread. The model must
/// outlive it.
template <typename T>
class Wavefront {
 public:
  Wavefront(const Model<T>& model, const TraceOptions& options);

  /// The bytes of primary rays, as many as there are places in `bytes`.
  void pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes);

  RayCounts counts() const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr int kBreadth = 7;  // depths that are taken together; trees grow as 2^depth

  struct Ray {
    RayCena<T> ray;
    RayStart<T> start;
    Colour<T> most;  // what the ledger expects of it
    T index;         // of its medium; 0: not known
    T path_weight;
    std::uint32_t parent, pixel;  // index into nodes_, or kNone; into ledgers_
    bool mirror;                  // of its parent's two
  };
  struct Node {
    Hit<T> hit;
    Branching<T> branching;
    Colour<T> own, mirrored, passed;  // its light, and what secondary rays saw times weights
    T path_weight;
    std::uint32_t parent, pixel;
    bool mirror;
  };

  void find_hits(int depth);
  void shade_nodes(std::size_t first);
  void ask_light(std::size_t first, const PointLight<T>& source);
  void find_arriving(const PointLight<T>& source);
  void light_up(Node& node, const Incidence<T>& incidence, const PointLight<T>& source,
                const Colour<T>& arriving);
  void branch(std::size_t first, int depth);
  void branch_off(std::uint32_t node, bool mirror, int depth);
  void finish_deep(int depth);
  void deliver(std::uint32_t parent, std::uint32_t pixel, bool mirror, const Colour<T>& colour);
  Colour<T> most_of_branch(const Node& node, bool mirror, int depth) const;
  bool wanted(const Node& node, T weight) const;

  const Model<T>& model_;
  TraceOptions options_;
  Packets<T> packets_;
  Tracer<T> deep_;  // beyond kBreadth
  RadianceBound<T> bound_;
  RayCounts counts_;
  std::vector<Ray> rays_, next_;
  std::vector<Node> nodes_;  // of all depths, in order
  std::vector<PixelLedger<T>> ledgers_;
  // The rays that go together, what they ask for, and what was found.
  struct Asked {
    std::uint32_t node;
    Incidence<T> incidence;
  };
  std::vector<Asked> asked_;
  std::vector<StartedRay<T>> together_;
  std::vector<char> met_;
  std::vector<Boundary<T>> boundaries_;
  std::vector<Colour<T>> arriving_;
  std::vector<Colour<T>> colours_;  // of the pixels
};

}  // namespace sir
