// TRACE (thesis 2.4.1, 3.3): follows a primary ray through mirrors and glass.
#pragma once

#include <vector>

#include "tracer/branching.h"
#include "tracer/pixel_ledger.h"
#include "tracer/radiance_bound.h"
#include "tracer/ray_counts.h"
#include "tracer/trace_log.h"
#include "tracer/trace_options.h"

namespace sir {

/// Traces one ray at a time; one for each thread. The model must outlive it.
template <typename T>
class Tracer {
 public:
  Tracer(const Model<T>& model, const TraceOptions& options);

  /// What a primary ray sees. `log`, if given, receives the whole tree.
  Colour<T> radiance(const RayCena<T>& primary, TraceLog* log = nullptr);

  /// to_rgb8(radiance(primary)), without the rays that cannot change a byte of it
  /// any more (see PixelLedger), unless all effects' rays are asked for.
  Rgb8 pixel(const RayCena<T>& primary);

  /// What a secondary ray sees that was cast at `depth` with this weight, in a
  /// medium of this index (0: not known). No ray is spared.
  Colour<T> radiance_of(const RayCena<T>& ray, const RayStart<T>& start, T index, T path_weight,
                        int depth);

  RayCounts counts() const {
    RayCounts counts = counts_;
    counts.exact = classifier_.exact_intersections();
    counts.costs = classifier_.costs();
    return counts;
  }

 private:
  enum class Secondary : std::uint8_t { mirror, through };

  // A point whose secondary rays are under way. The tree is walked depth
  // first with these on a stack, so that its depth is bounded by memory only.
  struct Open {
    Hit<T> hit;
    Branching<T> branching;
    Colour<T> colour;            // its own
    Colour<T> mirrored, passed;  // what the secondary rays saw, times their weights
    T path_weight;               // from the pixel to this ray
    int depth;
    int asked;       // secondary rays that had their turn
    Secondary turn;  // the one whose turn it is, or was last
    std::size_t log_index;
  };

  bool cast(const RayCena<T>& ray, const RayStart<T>& start, T index, T path_weight, int depth,
            RayKind kind, T factor, const Colour<T>& most);
  Colour<T> follow(const RayCena<T>& ray, const RayStart<T>& start, T index, T path_weight,
                   int depth);
  Colour<T> most_of(const Open& open, Secondary which) const;
  void advance();
  bool wanted(const Open& open, T weight) const;
  void deliver(Colour<T> colour);
  std::size_t log_ray(const RayCena<T>& ray, T path_weight, int depth, RayKind kind, T factor);
  void log_hit(const Open& open);

  const Model<T>& model_;
  TraceOptions options_;
  Classifier<T> classifier_;
  RayCounts counts_;
  std::vector<Open> stack_;
  Colour<T> result_{0};
  RadianceBound<T> bound_;
  PixelLedger<T> ledger_;
  TraceLog* log_ = nullptr;
};

}  // namespace sir
