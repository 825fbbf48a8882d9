// Illumination rays of scenes that let no light through (thesis 2.4.1): only
// whether there is a boundary matters, not which comes first.
#include "tracer/classify.h"

namespace sir {
namespace {

template <typename T>
struct Stretch {
  T from, to;
};

// Moves `from` on for as long as some stretch goes on from there, to `slack` at most apart.
template <typename T, typename EachStretch>
void pass_covered(T& from, T slack, const EachStretch& for_each) {
  for (bool moved = true; moved;) {
    moved = false;
    for_each([&](const Stretch<T>& stretch) {
      if (stretch.from > from + slack || stretch.to <= from) return;
      from = stretch.to;
      moved = true;
    });
  }
}

}  // namespace

// Where the light is clear of every primitive, the solid is not there for the
// last stretch of the ray. So one point on the way that is inside the solid
// proves a boundary behind it, wherever the ray began; and a ray on which no
// point is inside has none. A point counts as inside where it lies in a stretch
// too long for events that are one to cover.
template <typename T>
bool Classifier<T>::blocked(const RayCena<T>& ray, const RayStart<T>& start, T clearance) {
  if (!set_out(ray, start)) return false;
  const T speed = largest(ray.direction.v);
  const T roundings = Numeric<T>::kBoxRoundings * Numeric<T>::kEpsilon;
  const bool clear = products_serve(ray, start) && chain_ * speed <= solid_.products.gap &&
                     chain_ * speed + roundings * (largest(ray.origin.v) + speed) < clearance;
  if (clear) {
    Presence found = Presence::absent;
    add_costs(solid_.products.hierarchy.for_each_met_in_order(
        BoxProbe<T>(ray, widening_), T(1), [&](std::uint32_t index, T farthest) {
          const Presence one = presence_of(solid_.products.list[index]);
          if (one == Presence::doubtful) found = one;
          if (one != Presence::present) return farthest;
          found = one;
          return T(-1);
        }));
    if (found != Presence::doubtful) return found == Presence::present;
  }
  begin(ray, start, T(1));
  Boundary<T> boundary;
  bool met = next(boundary);
  while (met && !(boundary.t > 0)) met = next(boundary);  // a free ray's start
  return met && boundary.t < 1 && !Numeric<T>::same_event(boundary.t, T(1));
}

// Whether the products stand for the solid, as far as this Classifier goes.
template <typename T>
bool Classifier<T>::products_serve(const RayCena<T>& ray, const RayStart<T>& start) const {
  const T speed = largest(ray.direction.v);
  return engine_ == Engine::gates && solid_.products.complete && fusing_.within_ulps &&
         fusing_.nudge == 0 && speed > 0 && std::isfinite(speed) &&
         widening(start) <= solid_.products.gap;
}

// The leaf's span on this ray, worked out once.
template <typename T>
std::uint32_t Classifier<T>::met_at(std::uint32_t leaf) {
  Found& found = found_[leaf];
  if (found.ray != ray_number_)
    found = {ray_number_, gather(leaf) ? static_cast<std::uint32_t>(spans_.size() - 1) : kNone};
  return found.crossed;
}

// Fills members_ with the spans of a product; false where a positive is not met.
template <typename T>
bool Classifier<T>::find_members(const ProductRange& product) {
  found_.resize(solid_.leaves.size());
  members_.clear();
  positives_ = product.positives;
  const std::uint32_t* leaf = solid_.products.leaves.data() + product.first;
  for (std::uint32_t i = 0; i < product.positives + product.negatives; ++i) {
    const std::uint32_t met = met_at(leaf[i]);
    if (met != kNone) members_.push_back(met);
    else if (i < product.positives) return false;
  }
  return true;
}

// Of one product, on the ray between its start and t = 1.
template <typename T>
typename Classifier<T>::Presence Classifier<T>::presence_of(const ProductRange& product) {
  if (!find_members(product)) return Presence::absent;
  const bool carved = members_.size() > positives_;
  // Surely within all positives, and possibly.
  Stretch<T> sure{0, 1}, possible{0, 1};
  bool tangled = false;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Crossed& crossed = spans_[members_[i]];
    tangled = tangled || joined(crossed);
    if (i >= positives_) continue;
    const Span<T>& span = crossed.span;
    sure.from = std::max(sure.from, span.enter + span.enter_error);
    sure.to = std::min(sure.to, span.leave - span.leave_error);
    possible.from = std::max(possible.from, span.enter - span.enter_error);
    possible.to = std::min(possible.to, span.leave + span.leave_error);
  }
  if (tangled) return Presence::doubtful;
  if (!(possible.from < possible.to)) return Presence::absent;
  if (!carved) return sure.to - sure.from > chain_ ? Presence::present : Presence::doubtful;

  const auto possibly_carved = [&](const auto& visit) {
    for (std::size_t i = positives_; i < members_.size(); ++i) {
      const Span<T>& span = spans_[members_[i]].span;
      visit(Stretch<T>{span.enter - span.enter_error, span.leave + span.leave_error});
    }
  };
  while (sure.from < sure.to) {
    pass_covered(sure.from, chain_, possibly_carved);
    T to = sure.to;
    possibly_carved([&](const Stretch<T>& stretch) {
      if (stretch.from > sure.from) to = std::min(to, stretch.from);
    });
    if (to - sure.from > chain_) return Presence::present;
    sure.from = to;
  }
  pass_covered(possible.from, T(0), [&](const auto& visit) {
    for (std::size_t i = positives_; i < members_.size(); ++i) {
      const Span<T>& span = spans_[members_[i]].span;
      visit(Stretch<T>{span.enter + span.enter_error, span.leave - span.leave_error});
    }
  });
  return possible.from < possible.to ? Presence::doubtful : Presence::absent;
}

// Whether an end was moved to the start, which the primitive's numbers do not
// show: more digits could take that back.
template <typename T>
bool Classifier<T>::joined(const Crossed& crossed) const {
  const Span<T>& span = crossed.span;
  const auto at_start = [](T t, T error) { return t == 0 && error == 0; };
  return secondary_ && !stands_on(solid_.leaves[crossed.leaf]) &&
         (at_start(span.enter, span.enter_error) || at_start(span.leave, span.leave_error));
}

#define SIR_INSTANTIATE(T)                                                                  \
  template bool Classifier<T>::blocked(const RayCena<T>&, const RayStart<T>&, T);           \
  template bool Classifier<T>::products_serve(const RayCena<T>&, const RayStart<T>&) const; \
  template std::uint32_t Classifier<T>::met_at(std::uint32_t);                              \
  template bool Classifier<T>::find_members(const ProductRange&);                           \
  template bool Classifier<T>::joined(const Crossed&) const;
SIR_INSTANTIATE(float)
SIR_INSTANTIATE(double)
SIR_INSTANTIATE(long double)
#undef SIR_INSTANTIATE

}  // namespace sir
