#include "tracer/classify.h"

#include <algorithm>

#include "tracer/intersect_exact.h"
#include "tracer/surface_point.h"

namespace sir {

template <typename T>
Classifier<T>::Classifier(const Solid<T>& solid, Engine engine, Fusing fusing)
    : solid_(solid),
      engine_(engine),
      fusing_(fusing),
      chain_(2 * Numeric<T>::kCoincidentUlps * Numeric<T>::kEpsilon *
             static_cast<T>(2 * (solid.textbook.empty() ? std::size_t(solid.products.crowd)
                                                        : solid.leaves.size()) +
                            2)),
      stamp_(solid.gates.size(), 0),
      switched_(solid.gates.size(), 0) {
  inputs_.reserve(solid.gates.size());
  for (const Gate& gate : solid.gates) inputs_.push_back(gate.at_rest);
  if (engine == Engine::envelopes) envelope_tree_ = std::make_unique<const EnvelopeTree<T>>(solid);
}

// Makes ready for a ray; false where there is none.
template <typename T>
bool Classifier<T>::set_out(const RayCena<T>& ray, const RayStart<T>& start) {
  // A sweep that was left half-way is undone: outside everything again.
  // That is no cost of the next ray's, and of none where a thread has no next.
  const std::uint64_t combinations = costs_.combinations;
  for (Crossed& crossed : spans_)
    if (crossed.inside) toggle(crossed);
  costs_.combinations = combinations;
  inside_ = false;
  spans_.clear();
  events_.clear();
  combined_.clear();
  next_event_ = 0;
  ++ray_number_;
  ray_ = ray;
  start_ = start;
  secondary_ = start.leaf != RayStart<T>::kNowhere;
  widening_ = widening(start);
  const T speed = largest(ray.direction.v);
  if (!(speed > 0) || !std::isfinite(speed)) return false;  // no ray in T
  if (solid_.textbook.empty()) set_pace(speed);
  else behind_ = kTextbookStart<T> / length(ray.direction);
  return true;
}

// How far a primitive may lie from the start that join_start() takes to be there. What
// is no number, or too large for one, is anything.
template <typename T>
T Classifier<T>::widening(const RayStart<T>& start) const {
  if (start.leaf == RayStart<T>::kNowhere || !solid_.textbook.empty()) return 0;
  const T widening = start.error * solid_.spread;
  return widening >= 0 ? widening : std::numeric_limits<T>::infinity();
}

template <typename T>
void Classifier<T>::begin(const RayCena<T>& ray, const RayStart<T>& start, T farthest) {
  if (!set_out(ray, start)) return;
  if (engine_ != Engine::gates) {
    gather_in_order(ray, farthest);
    settle();
    combine_all();
    return;
  }
  add_costs(
      solid_.hierarchy.for_each_met(BoxProbe<T>(ray, widening_), farthest, [&](std::uint32_t leaf) {
        gather(leaf);
        return false;
      }));
  settle();
}

template <typename T>
void Classifier<T>::set_pace(T speed) {
  pace_ = std::ldexp(T(1), -std::ilogb(speed));
  tame_ = std::isnormal(speed) && std::isnormal(pace_);
  for (int axis = 0; axis < 3; ++axis) {
    const T d = std::abs(ray_.direction.v[axis]);
    tame_ = tame_ && (d == 0 || d * pace_ > Numeric<T>::kWellAboveUnderflow);
  }
  start_t_ = secondary_ ? largest(ray_.origin.v) / speed : T(0);
}

// As if it were exact: what has no error is never in doubt.
template <typename T>
bool Classifier<T>::gather_by_textbook(std::uint32_t index) {
  Span<T> span;
  if (!intersect_as_in_textbooks(solid_.textbook[index], ray_, span) || span.leave < 0)
    return false;
  spans_.push_back({span, span, index, false, true});
  return true;
}

// True where the primitive is met.
template <typename T>
bool Classifier<T>::gather(std::uint32_t index) {
  const Leaf<T>& leaf = solid_.leaves[index];
  if (!solid_.textbook.empty()) {
    ++costs_.primitives[static_cast<std::size_t>(leaf.kind)];
    return gather_by_textbook(index);
  }
  if (stands_on(leaf) && !start_.inward) return false;  // convex: never met again
  ++costs_.primitives[static_cast<std::size_t>(leaf.kind)];
  Span<T> span;
  const T pace = pace_ * leaf.pace;
  const bool tame = tame_ && leaf.tame && std::isnormal(pace);
  const Crossing crossing =
      tame ? intersect(leaf.kind, leaf.to_local(ray_, pace), span) : Crossing::unsure;
  if (crossing == Crossing::misses) return false;
  const bool exact = crossing == Crossing::unsure;
  if (exact) {
    if (!cross_exactly(index, span)) return false;
  } else {
    span.enter *= pace;
    span.leave *= pace;
    span.enter_error *= pace;
    span.leave_error *= pace;
  }
  join_start(index, span);
  // Behind the start without a doubt.
  if (span.leave < -span.leave_error || !(span.enter < span.leave)) return false;
  spans_.push_back({span, span, index, false, exact});
  return true;
}

template <typename T>
bool Classifier<T>::cross_exactly(std::uint32_t index, Span<T>& span) {
  ++exact_intersections_;
  return intersect_exactly(solid_.leaves[index].kind, solid_.placement(index), ray_,
                           start_t_ * Numeric<T>::kEpsilon / 8, span);
}

// The face that the ray stands on is at t = 0, and so are faces that coincide
// with it. In t that cannot be told, because a flat angle blows the distance up;
// in the primitive's own frame it can.
template <typename T>
void Classifier<T>::join_start(std::uint32_t index, Span<T>& span) const {
  if (!secondary_) return;
  const Leaf<T>& leaf = solid_.leaves[index];
  if (stands_on(leaf)) {
    span.enter = span.enter_error = T(0);
    return;
  }
  const RayLocal<T> local = leaf.placement.unapply(ray_);
  const T tolerance = leaf.stretch * start_.error;
  // On an edge the start is on a face that the ray crosses elsewhere too: where
  // it passes the face here it does so in the right direction.
  const auto passes_here = [&](std::uint8_t face, T way) {
    return on_face(leaf.kind, face, local.origin, tolerance) &&
           way * dot(outward_normal(leaf.kind, face, local.origin), local.direction) >= 0;
  };
  if (span.enter_face == span.leave_face) {
    if (!on_face(leaf.kind, span.enter_face, local.origin, tolerance)) return;
    if (std::abs(span.enter) <= std::abs(span.leave)) span.enter = span.enter_error = T(0);
    else span.leave = span.leave_error = T(0);
    return;
  }
  if (passes_here(span.enter_face, T(-1))) span.enter = span.enter_error = T(0);
  if (passes_here(span.leave_face, T(1))) span.leave = span.leave_error = T(0);
}

// Sorts the events, with more digits wherever the order, or what is one event,
// could depend on rounding. A primitive is sharpened once at most. Not neighbours
// only are compared, but all of a group that may touch: among equal ones who is
// whose neighbour depends on the shape of the tree, and the digits of t must not.
template <typename T>
void Classifier<T>::settle() {
  list_events();
  for (bool settled = false; !settled;) {
    settled = true;
    T most = 0;
    for (const Event& event : events_) most = std::max(most, event.error);
    if (!(most > 0)) return;
    for (std::size_t first = 0; first < events_.size();) {
      std::size_t end = first + 1;
      while (end < events_.size() && !apart(events_[end - 1], events_[end], 2 * most)) ++end;
      if (sharpen_group(first, end)) settled = false;
      first = end;
    }
    if (!settled) list_events();
  }
}

// Sharpens what is in doubt among the events [first, end); true where anything
// was. In a large group, where faces coincide in numbers, that is everything.
template <typename T>
bool Classifier<T>::sharpen_group(std::size_t first, std::size_t end) {
  constexpr std::size_t kLarge = 16;
  bool sharpened = false;
  const auto sharpen_one = [&](const Event& event) {
    const Crossed& crossed = spans_[event.crossed];
    if (crossed.exact) return;
    sharpen(crossed);
    sharpened = true;
  };
  for (std::size_t i = first; i < end; ++i) {
    if (doubtful(events_[i]) || end - first > kLarge) sharpen_one(events_[i]);
    for (std::size_t j = i + 1; end - first <= kLarge && j < end; ++j) {
      if (!doubtful(events_[i], events_[j])) continue;
      sharpen_one(events_[i]);
      sharpen_one(events_[j]);
    }
  }
  return sharpened;
}

template <typename T>
void Classifier<T>::list_events() {
  events_.clear();
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    const Span<T>& span = spans_[i].span;
    if (span.leave < -span.leave_error || !(span.enter < span.leave)) continue;
    const std::uint32_t leaf = spans_[i].leaf;
    events_.push_back({nudged(span.enter, leaf, true), span.enter_error, i, true});
    events_.push_back({nudged(span.leave, leaf, false), span.leave_error, i, false});
  }
  std::sort(events_.begin(), events_.end(),
            [](const Event& a, const Event& b) { return a.t < b.t; });
}

template <typename T>
T Classifier<T>::nudged(T t, std::uint32_t leaf, bool enters) const {
  if (fusing_.nudge == 0) return t;
  const auto ulps = static_cast<T>(fusing_.nudge) * static_cast<T>(1 + leaf % 31);
  return t + (enters ? -ulps : ulps) * Numeric<T>::ulp(t);
}

// Whether an event may be behind the start or not, or is not known well enough:
// that is, to so many roundings of t, or on a secondary ray, whose start is
// rounded itself, of the coordinates of the point.
template <typename T>
bool Classifier<T>::doubtful(const Event& event) const {
  if (!(event.error > 0) || event.t < -event.error) return false;
  return event.error > Numeric<T>::kTrustedRoundings * Numeric<T>::kEpsilon * (event.t + start_t_);
}

// Whether two events are two, if their t are off by no more than `error` in all.
template <typename T>
bool Classifier<T>::apart(const Event& a, const Event& b, T error) const {
  constexpr T kReach = Numeric<T>::kCoincidentUlps * Numeric<T>::kEpsilon;
  const T size = std::max(std::abs(a.t), std::abs(b.t));
  return b.t - a.t - error > kReach * (size + error);  // ulp(t) <= epsilon |t|
}

// Whether two may be one event or two.
template <typename T>
bool Classifier<T>::doubtful(const Event& a, const Event& b) const {
  const T error = a.error + b.error;
  if (!(error > 0) || apart(a, b, error)) return false;
  if (a.enters == b.enters &&
      solid_.leaves[spans_[a.crossed].leaf].shape == solid_.leaves[spans_[b.crossed].leaf].shape)
    return false;  // the same end of the same thing
  const T size = std::max(std::abs(a.t), std::abs(b.t));
  return !(b.t - a.t + error <= Numeric<T>::kCoincidentUlps * Numeric<T>::ulp(size - error));
}

// Those of one kind and place together, so that they stay one event.
template <typename T>
void Classifier<T>::sharpen(const Crossed& doubted) {
  const std::uint32_t shape = solid_.leaves[doubted.leaf].shape;
  Span<T> exact;
  if (cross_exactly(doubted.leaf, exact)) join_start(doubted.leaf, exact);
  else exact.enter = exact.leave = T(0);  // an empty one is left out
  for (Crossed& crossed : spans_) {
    if (crossed.exact || solid_.leaves[crossed.leaf].shape != shape) continue;
    crossed.exact = true;
    crossed.span = exact;
  }
}

// Switches a primitive and passes the change up while gates switch; true when
// it reaches the whole solid. Gates are monotone: all changes go one way.
template <typename T>
bool Classifier<T>::toggle(Crossed& crossed) {
  crossed.inside = !crossed.inside;
  const Leaf<T>& leaf = solid_.leaves[crossed.leaf];
  const std::int32_t step = crossed.inside != leaf.complemented ? 1 : -1;
  for (std::int32_t g = leaf.gate; g >= 0;) {
    const auto at = static_cast<std::size_t>(g);
    const Gate& gate = solid_.gates[at];
    const bool before = inputs_[at] >= gate.needed;
    ++costs_.combinations;
    inputs_[at] += step;
    if (before == (inputs_[at] >= gate.needed)) return false;
    switched_[at] = stamp_[at] == cluster_ ? static_cast<std::uint8_t>(switched_[at] ^ 1) : 1;
    stamp_[at] = cluster_;
    g = gate.parent;
  }
  return true;
}

template <typename T>
typename Classifier<T>::Event Classifier<T>::as_found(std::uint32_t crossed, bool enters) const {
  const Span<T>& span = spans_[crossed].found;
  if (enters) return {span.enter, span.enter_error, crossed, true};
  return {span.leave, span.leave_error, crossed, false};
}

// What is reported of a boundary is what its own primitive says, and does not change
// with what else is near: not on the surfaces that it coincides with, nor on those
// that the walk did or did not come by.
template <typename T>
Boundary<T> Classifier<T>::boundary_of(const Event& event, bool entering) const {
  const Crossed& crossed = spans_[event.crossed];
  const auto face = event.enters ? crossed.span.enter_face : crossed.span.leave_face;
  T t = event.t, error = event.error;
  if (crossed.exact && fusing_.nudge == 0) {
    const Event found = as_found(event.crossed, event.enters);
    if (found.error > 0 && !doubtful(found)) {
      t = found.t;
      error = found.error;
    }
  }
  // A zero may have come out negative.
  return {t + T(0), error, crossed.leaf, face, entering, event.enters};
}

template <typename T>
bool Classifier<T>::next(Boundary<T>& boundary) {
  if (engine_ != Engine::gates) {
    if (next_event_ >= combined_.size()) return false;
    boundary = combined_[next_event_++];
    return true;
  }
  while (next_event_ < events_.size()) {
    std::size_t end = next_event_ + 1;
    while (end < events_.size() && same_event(events_[end - 1], events_[end])) ++end;
    if (pass_cluster(end, boundary) && reportable(boundary.t)) return true;
  }
  return false;
}

// Passes the events [next_event_, end), which are one; true where the solid's
// state differs behind them.
template <typename T>
bool Classifier<T>::pass_cluster(std::size_t end, Boundary<T>& boundary) {
  const std::size_t begin = next_event_;
  next_event_ = end;
  ++cluster_;
  const bool before = inside_;
  for (std::size_t i = begin; i < end; ++i)
    if (toggle(spans_[events_[i].crossed])) inside_ = !inside_;
  if (inside_ == before) return false;
  if (end == begin + 1) {
    boundary = boundary_of(events_[begin], inside_);
    return true;
  }
  bool found = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (!changed_with_solid(events_[i], events_[begin].t)) continue;
    const Boundary<T> candidate = boundary_of(events_[i], inside_);
    if (!found || precedes(candidate, boundary)) boundary = candidate;
    found = true;
  }
  return found;
}

// Whether this event's surface is one of those that carry the boundary: it and
// every gate above it changed in this cluster, and the same way as the solid.
template <typename T>
bool Classifier<T>::changed_with_solid(const Event& event, T cluster_start) const {
  const Crossed& crossed = spans_[event.crossed];
  const Leaf<T>& leaf = solid_.leaves[crossed.leaf];
  // Both ends in one cluster: the primitive is as it was.
  if (event.enters ? !crossed.inside : crossed.span.enter >= cluster_start) return false;
  if ((event.enters != leaf.complemented) != inside_) return false;
  for (std::int32_t g = leaf.gate; g >= 0; g = solid_.gates[static_cast<std::size_t>(g)].parent) {
    const auto at = static_cast<std::size_t>(g);
    const bool now = inputs_[at] >= solid_.gates[at].needed;
    if (stamp_[at] != cluster_ || switched_[at] == 0 || now != inside_) return false;
  }
  return true;
}

template <typename T>
bool Classifier<T>::precedes(const Boundary<T>& a, const Boundary<T>& b) const {
  const auto node_a = solid_.leaves[a.leaf].node, node_b = solid_.leaves[b.leaf].node;
  return node_a != node_b ? node_a < node_b : a.face < b.face;
}

template class Classifier<float>;
template class Classifier<double>;
template class Classifier<long double>;

}  // namespace sir
