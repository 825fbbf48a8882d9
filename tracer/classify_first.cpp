// The first boundary of a ray (thesis 2.3.6, 2.5) without the others: TRACE needs no
// more. Each product that the ray meets is asked where it changes first, the nearer
// ones first, and the least of these is the solid's.
#include "tracer/classify.h"

namespace sir {

// It is, where it is clear. That is: no other change of a product is as near as a
// chain of events that are one could reach, and none of the product's own events,
// so that no other surface could name it; what is at the start is known; and at most
// one product is there at the start, whose end comes before all the others, for the
// first of several ends is none of the union. Else the general way has the answer.
template <typename T>
bool Classifier<T>::first(const RayCena<T>& ray, const RayStart<T>& start, Boundary<T>& boundary,
                          T farthest) {
  if (solid_.leaves.size() > kFew && products_serve(ray, start) && set_out(ray, start)) {
    T near = farthest;
    const Presence found = first_surely(farthest, boundary, near);
    if (found != Presence::doubtful) return found == Presence::present;
    // It is hardly ever further than where a product surely changes. If it is nearer than
    // what was looked at, by more than events that are one can reach, nothing beyond has
    // a part in it.
    if (near < farthest) {
      begin(ray, start, near);
      if (next(boundary) && boundary.t + boundary.error + 2 * chained(boundary.t, 0) < near)
        return true;
    }
  }
  begin(ray, start, farthest);
  return next(boundary);
}

template <typename T>
typename Classifier<T>::Presence Classifier<T>::first_surely(T farthest, Boundary<T>& boundary,
                                                             T& near) {
  Nearest nearest;
  add_costs(solid_.products.hierarchy.for_each_met_in_order(
      BoxProbe<T>(ray_, widening_), farthest, [&](std::uint32_t index, T limit) {
        const Change change = change_of(solid_.products.list[index], limit);
        if (change.certainty == Presence::absent) return limit;
        consider(change, nearest);
        if (!(nearest.doubtful_from > 0)) return T(-1);  // nothing will be clear any more
        if (nearest.change.certainty != Presence::present) return limit;
        return std::min(limit, nearest.change.event.t + 2 * reach(nearest.change.event));
      }));
  const Event& event = nearest.change.event;
  if (nearest.change.certainty == Presence::present)
    near = std::min(near, T(1.0625) * (event.t + event.error));
  else
    return nearest.doubtful_from < std::numeric_limits<T>::infinity() ? Presence::doubtful
                                                                      : Presence::absent;
  if (!(nearest.doubtful_from > event.t + reach(event))) return Presence::doubtful;
  if (nearest.inside > (nearest.change.inside ? 1 : 0)) return Presence::doubtful;
  if (!(reach(event) * largest(ray_.direction.v) <= solid_.products.gap)) return Presence::doubtful;
  boundary = boundary_of(event, !nearest.change.inside);
  return Presence::present;
}

// Takes the change of one more product into account.
template <typename T>
void Classifier<T>::consider(const Change& change, Nearest& nearest) const {
  if (change.certainty == Presence::doubtful) {
    nearest.doubtful_from = std::min(nearest.doubtful_from, change.from);
    return;
  }
  nearest.inside += change.inside ? 1 : 0;
  if (nearest.change.certainty != Presence::present) {
    nearest.change = change;
    return;
  }
  const Event &a = nearest.change.event, &b = change.event;
  const bool same = a.crossed == b.crossed && a.enters == b.enters;
  const T least = std::min(a.t, b.t);
  // One event enters both; or else it may be none of the union.
  if (same ? change.inside || nearest.change.inside
           : !(std::abs(a.t - b.t) > a.error + b.error + chained(a.t, b.t)))
    nearest.doubtful_from = std::min(nearest.doubtful_from, least);
  if (b.t < a.t) nearest.change = change;
}

template <typename T>
typename Classifier<T>::Change Classifier<T>::change_of(const ProductRange& product, T farthest) {
  // Before the negatives are intersected: whether the positives have a stretch in common.
  found_.resize(solid_.leaves.size());
  members_.clear();
  positives_ = product.positives;
  const std::uint32_t* leaf = solid_.products.leaves.data() + product.first;
  T from = 0, to = farthest;
  const auto narrow = [&](const Span<T>& span) {
    from = std::max(from, span.enter - span.enter_error);
    to = std::min(to, span.leave + span.leave_error);
    return from <= to;
  };
  for (std::uint32_t i = 0; i < product.positives; ++i) {
    const std::uint32_t met = met_at(leaf[i]);
    if (met == kNone || !narrow(spans_[met].span)) return {};
    members_.push_back(met);
  }
  for (const std::uint32_t member : members_)
    if (!trust(member) || !narrow(spans_[member].span)) return {};
  for (std::uint32_t i = product.positives; i < product.positives + product.negatives; ++i) {
    const std::uint32_t met = met_at(leaf[i]);
    if (met == kNone) continue;
    const auto beside = [&](const Span<T>& span) {
      return span.enter - span.enter_error <= to + chained(to, to) &&
             span.leave + span.leave_error >= from - chained(from, from);
    };
    if (beside(spans_[met].span) && trust(met) && beside(spans_[met].span)) members_.push_back(met);
  }
  Change change = change_within();
  change.from = from;
  return change;
}

// Sees to it that a span is known well enough, as settle() would; false where more
// digits say that it is empty, or behind the start.
template <typename T>
bool Classifier<T>::trust(std::uint32_t index) {
  Crossed& crossed = spans_[index];
  if (!crossed.exact && (doubtful(as_found(index, true)) || doubtful(as_found(index, false)))) {
    crossed.exact = true;
    if (cross_exactly(crossed.leaf, crossed.span)) join_start(crossed.leaf, crossed.span);
    else crossed.span.enter = crossed.span.leave = T(0);
  }
  return crossed.span.enter < crossed.span.leave && crossed.span.leave >= -crossed.span.leave_error;
}

// Of the product whose spans are members_.
template <typename T>
typename Classifier<T>::Change Classifier<T>::change_within() const {
  Change change;
  change.certainty = Presence::doubtful;
  Event entry{T(0), T(0), kNone, true},
      exit{std::numeric_limits<T>::infinity(), T(0), kNone, false};
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Span<T>& span = spans_[members_[i]].span;
    if (vague({span.enter, span.enter_error, members_[i], true}) ||
        vague({span.leave, span.leave_error, members_[i], false}))
      return change;
    if (i >= positives_) continue;
    if (span.enter > entry.t) entry = {span.enter, span.enter_error, members_[i], true};
    if (span.leave < exit.t) exit = {span.leave, span.leave_error, members_[i], false};
  }
  // Past what is cut away, for as long as that goes on.
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t i = positives_; i < members_.size(); ++i) {
      const Span<T>& span = spans_[members_[i]].span;
      const bool at_start = entry.crossed == kNone;
      const bool begun = at_start ? span.enter <= 0
                                  : entry.t - span.enter > entry.error + span.enter_error +
                                                               chained(entry.t, span.enter);
      const bool ended = at_start ? span.leave <= 0
                                  : !(span.leave - entry.t > entry.error + span.leave_error +
                                                                 chained(entry.t, span.leave));
      if (!begun || ended) continue;
      entry = {span.leave, span.leave_error, members_[i], false};
      moved = true;
    }
  }
  const T apart = entry.error + exit.error + chained(entry.t, exit.t);
  if (entry.t - exit.t > apart) return {};
  if (!(exit.t - entry.t > apart)) return change;
  change.inside = entry.crossed == kNone;
  if (change.inside) {
    for (std::size_t i = positives_; i < members_.size(); ++i) {
      const Span<T>& span = spans_[members_[i]].span;
      if (span.enter > 0 && span.enter < exit.t)
        exit = {span.enter, span.enter_error, members_[i], true};
    }
    entry = exit;
  }
  if (!isolated(entry)) return change;
  change.event = entry;
  change.certainty = Presence::present;
  return change;
}

// Whether no other event of the product could be one with this.
template <typename T>
bool Classifier<T>::isolated(const Event& event) const {
  const auto apart = [&](T t, T error) {
    return std::abs(event.t - t) > event.error + error + chained(event.t, t);
  };
  for (const std::uint32_t member : members_) {
    const Span<T>& span = spans_[member].span;
    const bool own = member == event.crossed;
    if (!(own && event.enters) && !apart(span.enter, span.enter_error)) return false;
    if (!(own && !event.enters) && !apart(span.leave, span.leave_error)) return false;
  }
  return true;
}

// Whether an end is not known well enough, or may be behind the start or not.
template <typename T>
bool Classifier<T>::vague(const Event& event) const {
  if (doubtful(event)) return true;
  const bool own_start =
      event.enters && event.t == 0 && stands_on(solid_.leaves[spans_[event.crossed].leaf]);
  return std::abs(event.t) <= event.error && !own_start;
}

template bool Classifier<float>::first(const RayCena<float>&, const RayStart<float>&,
                                       Boundary<float>&, float);
template bool Classifier<double>::first(const RayCena<double>&, const RayStart<double>&,
                                        Boundary<double>&, double);
template bool Classifier<long double>::first(const RayCena<long double>&,
                                             const RayStart<long double>&, Boundary<long double>&,
                                             long double);

}  // namespace sir
