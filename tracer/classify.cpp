#include "tracer/classify.h"

#include <algorithm>

#include "tracer/surface_point.h"

namespace sir {

template <typename T>
Classifier<T>::Classifier(const Solid<T>& solid, Engine engine)
    : solid_(solid),
      engine_(engine),
      stamp_(solid.gates.size(), 0),
      switched_(solid.gates.size(), 0) {
  inputs_.reserve(solid.gates.size());
  for (const Gate& gate : solid.gates) inputs_.push_back(gate.at_rest);
}

template <typename T>
void Classifier<T>::begin(const RayCena<T>& ray, const RayStart<T>& start, T farthest) {
  // A sweep that was left half-way is undone: outside everything again.
  for (Crossed& crossed : spans_)
    if (crossed.inside) toggle(crossed);
  inside_ = false;
  spans_.clear();
  events_.clear();
  next_event_ = 0;
  secondary_ = start.leaf != RayStart<T>::kNowhere;

  if (engine_ == Engine::roth) {
    for (std::uint32_t leaf = 0; leaf < solid_.leaves.size(); ++leaf) gather(leaf, ray, start);
  } else {
    const BoxProbe<T> probe(ray, solid_.box_margin(ray.origin));
    solid_.hierarchy.for_each_met(probe, farthest,
                                  [&](std::uint32_t leaf) { gather(leaf, ray, start); });
  }
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    events_.push_back({spans_[i].span.enter, i, true});
    events_.push_back({spans_[i].span.leave, i, false});
  }
  std::sort(events_.begin(), events_.end(),
            [](const Event& a, const Event& b) { return a.t < b.t; });
  if (engine_ == Engine::roth) combine_all();
}

template <typename T>
void Classifier<T>::gather(std::uint32_t index, const RayCena<T>& ray, const RayStart<T>& start) {
  const Leaf<T>& leaf = solid_.leaves[index];
  if (index == start.leaf && !start.inward) return;  // convex: never met again
  Span<T> span;
  const bool crosses =
      leaf.unit > 0
          ? intersect(leaf.kind, leaf.placement.unapply_times_divisor(ray), leaf.unit, span)
          : intersect(leaf.kind, leaf.placement.unapply(ray), T(1), span);
  if (!crosses) return;
  if (index == start.leaf) span.enter = T(0);
  else if (secondary_) snap_to_start(leaf, leaf.placement.unapply(ray.origin), start.error, span);
  if (span.leave < 0 || !(span.enter < span.leave)) return;
  spans_.push_back({span, index, false});
}

// Faces that coincide with the one the ray stands on are at t = 0 too. In t
// that cannot be told, because a flat angle blows the distance up; in the
// primitive's own frame it can.
template <typename T>
void Classifier<T>::snap_to_start(const Leaf<T>& leaf, PointLocal<T> start, T error,
                                  Span<T>& span) const {
  const T tolerance = leaf.stretch * error;
  const bool enters_here = on_face(leaf.kind, span.enter_face, start, tolerance);
  const bool leaves_here = on_face(leaf.kind, span.leave_face, start, tolerance);
  const bool same_surface = span.enter_face == span.leave_face;
  const bool enter_is_nearer = std::abs(span.enter) <= std::abs(span.leave);
  if (enters_here && (!same_surface || enter_is_nearer)) span.enter = T(0);
  if (leaves_here && (!same_surface || !enter_is_nearer)) span.leave = T(0);
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
    inputs_[at] += step;
    if (before == (inputs_[at] >= gate.needed)) return false;
    switched_[at] = stamp_[at] == cluster_ ? static_cast<std::uint8_t>(switched_[at] ^ 1) : 1;
    stamp_[at] = cluster_;
    g = gate.parent;
  }
  return true;
}

template <typename T>
Boundary<T> Classifier<T>::boundary_of(const Event& event, bool entering) const {
  const Crossed& crossed = spans_[event.crossed];
  const auto face = event.enters ? crossed.span.enter_face : crossed.span.leave_face;
  // A zero may have come out negative.
  return {event.t + T(0), crossed.leaf, face, entering, event.enters};
}

template <typename T>
bool Classifier<T>::next(Boundary<T>& boundary) {
  if (engine_ == Engine::roth) {
    if (next_event_ >= combined_.size()) return false;
    boundary = combined_[next_event_++];
    return true;
  }
  while (next_event_ < events_.size()) {
    std::size_t end = next_event_ + 1;
    while (end < events_.size() && Numeric<T>::same_event(events_[end - 1].t, events_[end].t))
      ++end;
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

}  // namespace sir
