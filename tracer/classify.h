// RAY-TRACING (thesis 2.3.6, 3.3): where a ray enters and leaves the solid.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "tracer/cost_counts.h"
#include "tracer/envelope_tree.h"
#include "tracer/solid.h"

namespace sir {

/// A boundary of the combined solid on a ray: an entry of the thesis's list
/// CLASSIFICA.
template <typename T>
struct Boundary {
  T t = 0;                     ///< in units of the ray's direction
  T error = 0;                 ///< the true t lies within this of it
  std::uint32_t leaf = 0;      ///< index into Solid::leaves of the primitive that names it
  std::uint8_t face = 0;       ///< of that primitive
  bool entering = false;       ///< side: IN, from outside the solid to its inside
  bool leaf_entering = false;  ///< the ray enters that primitive: not the same in a bore
};

/// Where a ray begins. A secondary ray says on which face it stands and to
/// which side of it it leaves; that replaces every offset from the surface.
template <typename T>
struct RayStart {
  static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t leaf = kNowhere;  ///< kNowhere: a free ray
  bool inward = false;            ///< into that primitive
  T error = 0;                    ///< how far rounding may have moved the origin, in SC_CENA
};

/// How boundaries are found. `gates` and `roth` give the same list; so does
/// `envelopes`, but where a primitive that it passed by lies within the errors of a
/// boundary: that one may then differ in the last digits of t.
enum class Engine : std::uint8_t {
  gates,     ///< hierarchy of envelopes, one sweep along the ray over flattened gates
  roth,      ///< the thesis's: every primitive, then table 2.4 at every composite
  envelopes  ///< the same with an envelope at each node of the composition (2.5.2)
};

/// How boundaries that are all but one are treated. Another than the usual way
/// shows what hangs on it (see hesitation.h).
struct Fusing {
  bool within_ulps = true;  ///< those within 32 ulp of t are one event; else only equal ones
  int nudge = 0;            ///< 1 or -1: first each primitive swells or shrinks by 1 to 31 ulp of t
};

/// Finds boundaries along one ray at a time. Holds scratch space: one for each
/// thread.
///
/// Boundaries of primitives closer than 32 ulp of t (chained) are one event. What
/// is one event, which comes first and which lie behind the start is decided on
/// bounds of the errors; where these leave a doubt, or t could be off by more
/// than Numeric::kTrustedRoundings, intersect_exactly() says. So the list is the
/// one of exact arithmetic on the file's numbers, whatever the scene. A boundary
/// that was in no doubt itself is reported as it was found, even if the other end
/// of its primitive's span needed more digits.
/// At each event the composition is asked once before and once after; where
/// that differs there is a boundary, so that no span of zero length can arise.
/// It is named by the primitive's surface that turns the same way as the
/// result, of the lowest node number, then the lowest face.
///
/// A solid that was built for Formulas::textbook is intersected by these alone,
/// and nothing is ever doubted; the sweep is the same.
template <typename T>
class Classifier {
 public:
  explicit Classifier(const Solid<T>& solid, Engine engine = Engine::gates, Fusing fusing = {});

  /// Starts on a ray. Boundaries beyond `farthest` may be missing. A free ray
  /// has its boundaries at t >= 0, a secondary one at t > 0.
  void begin(const RayCena<T>& ray, const RayStart<T>& start = {},
             T farthest = std::numeric_limits<T>::infinity());

  /// The next boundary in order of t; false when there is none.
  bool next(Boundary<T>& boundary);

  /// Where there are no more primitives, next() after begin() is as fast as what
  /// does with less.
  static constexpr std::size_t kFew = 8;

  /// The first boundary that begin() and next() would find; false where there is
  /// none. Where it is clear which one that is, only what the ray meets up to there
  /// is intersected, and nothing is sorted. The digits are the same too, unless a
  /// primitive crosses within the errors that has no part in the solid there: that
  /// one makes next() ask for more digits. next() may not be asked afterwards.
  bool first(const RayCena<T>& ray, const RayStart<T>& start, Boundary<T>& boundary,
             T farthest = std::numeric_limits<T>::infinity());

  /// Whether the solid has a boundary strictly between the ray's start and t = 1:
  /// next() after begin() would say the same, but where it is clear without
  /// ordering the boundaries, they are not. `clearance`: no primitive that adds to
  /// the solid is nearer to the point at t = 1, along any axis of SC_CENA; 0 where
  /// that is not known.
  bool blocked(const RayCena<T>& ray, const RayStart<T>& start, T clearance);

  /// Spans found by begin(), first() or blocked(): intersections with primitives.
  std::size_t spans() const { return spans_.size(); }

  /// How many primitives had to be intersected exactly, since the beginning.
  std::uint64_t exact_intersections() const { return exact_intersections_; }

  /// What all rays have cost since the beginning.
  CostCounts costs() const {
    CostCounts costs = costs_;
    costs.calls += engine_ == Engine::gates ? costs.transformations() : 0;
    return costs;
  }

 private:
  struct Crossed {
    Span<T> span;   // with more digits, where the order depended on them
    Span<T> found;  // without
    std::uint32_t leaf;
    bool inside;
    bool exact;
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Event {
    T t, error;
    std::uint32_t crossed;  // index into spans_
    bool enters;
  };

  /// Whether the ray starts on this primitive, or on another in the same place.
  bool stands_on(const Leaf<T>& leaf) const {
    return secondary_ && leaf.shape == solid_.leaves[start_.leaf].shape;
  }
  void add_costs(const HierarchyCosts& costs) {
    costs_.envelopes += costs.envelopes;
    costs_.calls += costs.entered;
  }
  bool set_out(const RayCena<T>& ray, const RayStart<T>& start);
  void set_pace(T speed);
  bool gather(std::uint32_t leaf);
  bool gather_by_textbook(std::uint32_t leaf);
  enum class Presence : std::uint8_t { absent, present, doubtful };
  /// Where a product is first entered or left.
  struct Change {
    Presence certainty = Presence::absent;
    Event event{};        // if present
    bool inside = false;  // the product is there at the start: the change is that it ends
    T from = 0;           // if doubtful: not before
  };
  /// The nearest of the changes so far.
  struct Nearest {
    Change change;
    T doubtful_from = std::numeric_limits<T>::infinity();
    int inside = 0;
  };
  T widening(const RayStart<T>& start) const;
  bool products_serve(const RayCena<T>& ray, const RayStart<T>& start) const;
  std::uint32_t met_at(std::uint32_t leaf);
  bool find_members(const ProductRange& product);
  Presence presence_of(const ProductRange& product);
  Change change_of(const ProductRange& product, T farthest);
  Change change_within() const;
  bool trust(std::uint32_t index);
  bool isolated(const Event& event) const;
  bool vague(const Event& event) const;
  T chained(T a, T b) const { return chain_ * std::max(std::abs(a), std::abs(b)); }
  T reach(const Event& event) const { return event.error + 2 * chained(event.t, event.t); }
  void consider(const Change& change, Nearest& nearest) const;
  Presence first_surely(T farthest, Boundary<T>& boundary, T& near);
  bool joined(const Crossed& crossed) const;
  bool cross_exactly(std::uint32_t leaf, Span<T>& span);
  void join_start(std::uint32_t leaf, Span<T>& span) const;
  void settle();
  void list_events();
  bool doubtful(const Event& event) const;
  Event as_found(std::uint32_t crossed, bool enters) const;
  bool apart(const Event& a, const Event& b, T error) const;
  bool doubtful(const Event& a, const Event& b) const;
  void sharpen(const Crossed& doubted);
  bool sharpen_group(std::size_t first, std::size_t end);
  bool toggle(Crossed& crossed);
  bool reportable(T t) const { return secondary_ ? t > behind_ : t >= 0; }
  Boundary<T> boundary_of(const Event& event, bool entering) const;
  bool pass_cluster(std::size_t end, Boundary<T>& boundary);
  bool changed_with_solid(const Event& event, T cluster_start) const;
  bool precedes(const Boundary<T>& a, const Boundary<T>& b) const;
  void gather_in_order(const RayCena<T>& ray, T farthest);
  void combine_all();
  bool same_event(const Event& a, const Event& b) const {
    return fusing_.within_ulps ? Numeric<T>::same_event(a.t, b.t) : a.t == b.t;
  }
  T nudged(T t, std::uint32_t leaf, bool enters) const;

  const Solid<T>& solid_;
  Engine engine_;
  Fusing fusing_;
  RayCena<T> ray_;
  RayStart<T> start_;
  T chain_;           // events of a ray to t = 1 that are one do not reach as far as this
  bool tame_ = true;  // no component of the direction is lost to underflow
  T pace_ = 1;        // a power of two that brings the direction near 1
  T behind_ = 0;      // secondary rays: up to here nothing is reported
  T widening_ = 0;    // secondary rays: by so much boxes may miss them
  T start_t_ = 0;     // secondary rays: the t that is worth the origin's coordinates
  std::vector<Crossed> spans_;
  std::vector<Event> events_;
  // Products: which span of this ray is a leaf's, if `ray` is this one; and those of
  // the product that is looked at, positives first.
  struct Found {
    std::uint64_t ray = 0;
    std::uint32_t crossed = 0;  // index into spans_, or kNone
  };
  std::vector<Found> found_;
  std::vector<std::uint32_t> members_;
  std::size_t positives_ = 0;
  std::uint64_t ray_number_ = 0;
  std::uint64_t exact_intersections_ = 0;
  std::size_t next_event_ = 0;
  bool secondary_ = false;
  bool inside_ = false;                 // the solid, at the sweep's place
  std::vector<std::int32_t> inputs_;    // true inputs of each gate, at the sweep's place
  std::vector<std::uint64_t> stamp_;    // last cluster in which a gate switched
  std::vector<std::uint8_t> switched_;  // an odd number of times in that cluster
  std::uint64_t cluster_ = 0;
  // Engine::roth and Engine::envelopes:
  std::vector<Boundary<T>> combined_;  // the finished list
  std::vector<Visit> visits_;          // the nodes that the ray comes to
  std::unique_ptr<const EnvelopeTree<T>> envelope_tree_;
  CostCounts costs_;
};

}  // namespace sir
