#include "tracer/trace.h"

#include "tracer/ray_secondary.h"
#include "tracer/shade.h"

namespace sir {
namespace {

template <typename T>
Coefficients to_double(const Reflectance<T>& k) {
  return {glm::dvec3(k.ambient), glm::dvec3(k.diffuse),  double(k.specular),
          double(k.exponent),    double(k.transmission), double(k.index)};
}

}  // namespace

template <typename T>
Tracer<T>::Tracer(const Model<T>& model, const TraceOptions& options)
    : model_(model),
      options_(options),
      classifier_(model.solid, options.engine),
      bound_(model, options) {}

template <typename T>
Colour<T> Tracer<T>::radiance(const RayCena<T>& primary, TraceLog* log) {
  log_ = log;
  ledger_.open(false);
  ++counts_.primary;
  return follow(primary, {}, T(0), T(1), 1);
}

template <typename T>
Rgb8 Tracer<T>::pixel(const RayCena<T>& primary) {
  log_ = nullptr;
  ledger_.open(!model_.effects.exhaustive && bound_.bounded());
  ++counts_.primary;
  return to_rgb8(follow(primary, {}, T(0), T(1), 1));
}

template <typename T>
Colour<T> Tracer<T>::radiance_of(const RayCena<T>& ray, const RayStart<T>& start, T index,
                                 T path_weight, int depth) {
  log_ = nullptr;
  ledger_.open(false);
  return follow(ray, start, index, path_weight, depth);
}

template <typename T>
Colour<T> Tracer<T>::follow(const RayCena<T>& ray, const RayStart<T>& start, T index, T path_weight,
                            int depth) {
  stack_.clear();
  if (!cast(ray, start, index, path_weight, depth, RayKind::primary, T(1), Colour<T>(0)))
    return model_.background;
  while (!stack_.empty()) advance();
  return result_;
}

// Sends a ray and opens the point where it hits; false where it leaves the
// scene. `most`: what the ledger expects of it. An index of 0 stands for "not
// known yet": a ray that may begin inside.
template <typename T>
bool Tracer<T>::cast(const RayCena<T>& ray, const RayStart<T>& start, T index, T path_weight,
                     int depth, RayKind kind, T factor, const Colour<T>& most) {
  Boundary<T> boundary;
  const bool met = classifier_.first(ray, start, boundary);
  counts_.spans += classifier_.spans();
  const std::size_t log_index = log_ ? log_ray(ray, path_weight, depth, kind, factor) : 0;
  if (!met) {
    if (log_) (*log_)[log_index].colour = glm::dvec3(model_.background);
    ledger_.settle(most, path_weight * model_.background);
    return false;
  }
  Open& open = stack_.emplace_back();
  open.hit = hit_at(model_, ray, boundary);
  open.path_weight = path_weight;
  open.depth = depth;
  open.log_index = log_index;
  open.branching = branching_at(model_, open.hit, index);
  // The ledger expects what the secondary rays may bring, and in shade() the
  // lights, before it is asked whether all is decided.
  ledger_.expect(most_of(open, Secondary::mirror) + most_of(open, Secondary::through));
  ledger_.settle(most, Colour<T>(0));
  open.colour = shade(model_, classifier_, open.hit, counts_,
                      log_ ? &(*log_)[log_index].lights : nullptr, &ledger_, path_weight);
  if (log_) log_hit(open);
  return true;
}

template <typename T>
std::size_t Tracer<T>::log_ray(const RayCena<T>& ray, T path_weight, int depth, RayKind kind,
                               T factor) {
  TraceNode node;
  if (!stack_.empty()) node.parent = stack_.back().log_index;
  node.kind = kind;
  node.depth = depth;
  node.weight = double(path_weight);
  node.factor = double(factor);
  node.origin = glm::dvec3(ray.origin.v);
  node.direction = glm::dvec3(ray.direction.v);
  log_->push_back(node);
  return log_->size() - 1;
}

template <typename T>
void Tracer<T>::log_hit(const Open& open) {
  const Boundary<T>& boundary = open.hit.boundary;
  const Leaf<T>& leaf = model_.solid.leaves[boundary.leaf];
  TraceNode& node = (*log_)[open.log_index];
  node.hit = true;
  node.t = double(boundary.t);
  node.entering = boundary.entering;
  node.node = leaf.node;
  node.face = boundary.face;
  node.surface = leaf.surfaces[boundary.face];
  node.coefficients = to_double(*open.hit.reflectance);
  node.point = glm::dvec3(open.hit.point.v);
  node.normal = glm::dvec3(open.hit.normal.v);
  node.total_reflection = open.branching.total_reflection;
  node.local = glm::dvec3(open.colour);
}

template <typename T>
bool Tracer<T>::wanted(const Open& open, T weight) const {
  if (!(weight > 0)) return model_.effects.exhaustive;
  return open.path_weight * weight >= static_cast<T>(options_.cutoff);
}

// The most that the pixel may get from the mirrored or the refracted ray.
template <typename T>
Colour<T> Tracer<T>::most_of(const Open& open, Secondary which) const {
  const T weight =
      which == Secondary::mirror ? open.branching.mirror_weight : open.branching.through_weight;
  if (!(weight > 0)) return Colour<T>(0);
  if (open.depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::zero) return Colour<T>(0);
    return open.path_weight * weight * model_.background;
  }
  if (!wanted(open, weight)) return Colour<T>(0);
  return open.path_weight * weight * bound_.at(open.depth + 1);
}

// One step of the point on top of the stack: one of its secondary rays, or its
// completion. The heavier one goes first: after it the ledger may well be done.
template <typename T>
void Tracer<T>::advance() {
  Open& open = stack_.back();
  if (open.asked == 2) {
    const Colour<T> colour = open.colour + open.mirrored + open.passed;
    if (log_) (*log_)[open.log_index].colour = glm::dvec3(colour);
    stack_.pop_back();
    deliver(colour);
    return;
  }
  const bool through_first = !log_ && open.branching.through_weight > open.branching.mirror_weight;
  const bool mirror = (open.asked++ == 0) != through_first;
  open.turn = mirror ? Secondary::mirror : Secondary::through;
  const T weight = mirror ? open.branching.mirror_weight : open.branching.through_weight;
  const Colour<T> most = most_of(open, open.turn);
  if (open.depth >= options_.depth_limit) {
    if (options_.past_limit == PastLimit::background && weight > 0)
      (mirror ? open.mirrored : open.passed) = weight * model_.background;
    ledger_.settle(most, most);
    return;
  }
  const bool allowed =
      mirror ? model_.effects.reflection || weight > 0 : open.branching.has_through;
  if (!allowed || !wanted(open, weight)) return;
  if (ledger_.decided()) {
    ++counts_.spared;
    return;
  }
  ++(mirror ? counts_.reflected : counts_.refracted);
  const RayCena<T> ray{open.hit.point, mirror ? mirrored(open.hit.incident, open.hit.normal)
                                              : open.branching.through};
  const bool met =
      cast(ray, mirror ? open.hit.leaving_on_eye_side() : open.hit.leaving_through(),
           mirror ? open.branching.index : open.branching.index_beyond, open.path_weight * weight,
           open.depth + 1, mirror ? RayKind::reflected : RayKind::refracted, weight, most);
  // cast() may have moved the stack; where it opened nothing, the top is ours.
  if (!met) deliver(model_.background);
}

// Hands what a finished secondary ray saw to the point that sent it.
template <typename T>
void Tracer<T>::deliver(Colour<T> colour) {
  if (stack_.empty()) {
    result_ = colour;
    return;
  }
  Open& parent = stack_.back();
  const bool mirror = parent.turn == Secondary::mirror;
  const T weight = mirror ? parent.branching.mirror_weight : parent.branching.through_weight;
  if (weight > 0) (mirror ? parent.mirrored : parent.passed) = weight * colour;
}

template class Tracer<float>;
template class Tracer<double>;
template class Tracer<long double>;

}  // namespace sir
