// Illumination rays of scenes that let no light through (thesis 2.4.1): only
// whether there is a boundary matters, not which comes first.
#include "tracer/classify.h"

namespace sir {
namespace {

template <typename T>
T largest(const glm::vec<3, T>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

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
  const bool clear = engine_ == Engine::gates && solid_.textbook.empty() && fusing_.within_ulps &&
                     fusing_.nudge == 0 &&
                     chain_ * speed + roundings * (largest(ray.origin.v) + speed) < clearance;
  if (clear) {
    bool met = false;
    add_costs(solid_.hierarchy.for_each_met(BoxProbe<T>(ray), T(1), [&](std::uint32_t index) {
      const Leaf<T>& leaf = solid_.leaves[index];
      if (!gather(index) || leaf.product < 0) return false;
      const Product& product = solid_.products[static_cast<std::size_t>(leaf.product)];
      const auto last = static_cast<std::uint32_t>(spans_.size() - 1);
      met = product.alone && presence_of(product, last) == Presence::present;
      return met;
    }));
    if (met) return true;
    const Presence found = presence();
    if (found != Presence::doubtful) return found == Presence::present;
    settle();
  } else {
    begin(ray, start, T(1));
  }
  Boundary<T> boundary;
  bool met = next(boundary);
  while (met && !(boundary.t > 0)) met = next(boundary);  // a free ray's start
  return met && boundary.t < 1 && !Numeric<T>::same_event(boundary.t, T(1));
}

// Of the whole solid, on the ray between its start and t = 1.
template <typename T>
typename Classifier<T>::Presence Classifier<T>::presence() {
  if (spans_.empty()) return Presence::absent;
  last_of_.resize(solid_.products.size(), kNone);
  touched_.clear();
  bool doubtful = false;
  for (std::uint32_t i = 0; i < spans_.size(); ++i) {
    const std::int32_t product = solid_.leaves[spans_[i].leaf].product;
    if (product < 0) {
      doubtful = true;
      continue;
    }
    std::uint32_t& last = last_of_[static_cast<std::size_t>(product)];
    if (last == kNone) touched_.push_back(static_cast<std::uint32_t>(product));
    spans_[i].sibling = last;
    last = i;
  }
  bool present = false;
  for (const std::uint32_t product : touched_) {
    if (!present) {
      const Presence found = presence_of(solid_.products[product], last_of_[product]);
      present = found == Presence::present;
      doubtful = doubtful || found == Presence::doubtful;
    }
    last_of_[product] = kNone;
  }
  return present ? Presence::present : doubtful ? Presence::doubtful : Presence::absent;
}

// Of one product, whose spans hang together from `last` on.
template <typename T>
typename Classifier<T>::Presence Classifier<T>::presence_of(const Product& product,
                                                            std::uint32_t last) const {
  const auto for_each = [&](bool complemented, const auto& visit) {
    for (std::uint32_t i = last; i != kNone; i = spans_[i].sibling)
      if (solid_.leaves[spans_[i].leaf].complemented == complemented) visit(spans_[i]);
  };
  // Surely within all positives, and possibly.
  Stretch<T> sure{0, 1}, possible{0, 1};
  std::uint32_t positives = 0;
  bool tangled = false;
  for_each(false, [&](const Crossed& crossed) {
    const Span<T>& span = crossed.span;
    ++positives;
    tangled = tangled || joined(crossed);
    sure.from = std::max(sure.from, span.enter + span.enter_error);
    sure.to = std::min(sure.to, span.leave - span.leave_error);
    possible.from = std::max(possible.from, span.enter - span.enter_error);
    possible.to = std::min(possible.to, span.leave + span.leave_error);
  });
  if (positives < product.positives) return Presence::absent;
  bool carved = false;
  for_each(true, [&](const Crossed& crossed) {
    carved = true;
    tangled = tangled || joined(crossed);
  });
  if (tangled) return Presence::doubtful;
  if (!(possible.from < possible.to)) return Presence::absent;
  if (!carved) return sure.to - sure.from > chain_ ? Presence::present : Presence::doubtful;

  const auto possibly_carved = [&](const auto& visit) {
    for_each(true, [&](const Crossed& crossed) {
      const Span<T>& span = crossed.span;
      visit(Stretch<T>{span.enter - span.enter_error, span.leave + span.leave_error});
    });
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
    for_each(true, [&](const Crossed& crossed) {
      const Span<T>& span = crossed.span;
      visit(Stretch<T>{span.enter + span.enter_error, span.leave - span.leave_error});
    });
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

template bool Classifier<float>::blocked(const RayCena<float>&, const RayStart<float>&, float);
template bool Classifier<double>::blocked(const RayCena<double>&, const RayStart<double>&, double);
template bool Classifier<long double>::blocked(const RayCena<long double>&,
                                               const RayStart<long double>&, long double);

}  // namespace sir
