// Roth's combination as the thesis gives it (2.3.6, table 2.4): at every
// composite the two lists are merged and simplified. Kept plain: it is what
// faster ways are compared with; envelopes on its nodes are its one cure here.
#include <algorithm>

#include "tracer/classify.h"

namespace sir {
namespace {

bool combined(Operation operation, bool left, bool right) {
  switch (operation) {
    case Operation::union_of: return left || right;
    case Operation::difference: return left && !right;
    case Operation::intersection: return left && right;
  }
  return false;
}

}  // namespace

// Every primitive, or those whose envelope and those of all above it are met.
template <typename T>
void Classifier<T>::gather_in_order(const RayCena<T>& ray, T farthest) {
  if (envelope_tree_) {
    envelope_tree_->visit(BoxProbe<T>(ray, widening_), farthest, visits_, costs_);
  } else {
    visits_.clear();
    for (std::uint32_t step = 0; step < solid_.polish.size(); ++step)
      visits_.push_back({step, true});
    costs_.calls += visits_.size();
  }
  for (auto visit = visits_.rbegin(); visit != visits_.rend(); ++visit) {
    const PolishStep& step = solid_.polish[visit->step];
    if (visit->entered && step.is_leaf) gather(step.leaf);
  }
}

template <typename T>
void Classifier<T>::combine_all() {
  // Each boundary gets the number of its event, counted over the whole ray, so
  // that what is one event does not depend on the shape of the tree.
  struct Numbered {
    std::size_t event;
    Boundary<T> boundary;
  };
  using List = std::vector<Numbered>;
  std::vector<List> of_leaf(solid_.leaves.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (i > 0 && !same_event(events_[i - 1], events_[i])) ++number;
    const Boundary<T> boundary = boundary_of(events_[i], events_[i].enters);
    List& list = of_leaf[boundary.leaf];
    if (!list.empty() && list.back().event == number) list.clear();  // zero length
    else list.push_back({number, boundary});
  }

  const auto combine = [&](Operation operation, const List& left, const List& right) {
    List result;
    bool in_left = false, in_right = false;
    for (std::size_t i = 0, j = 0; i < left.size() || j < right.size();) {
      const std::size_t event = std::min(i < left.size() ? left[i].event : number + 1,
                                         j < right.size() ? right[j].event : number + 1);
      const bool before = combined(operation, in_left, in_right);
      const Numbered* from_left = nullptr;
      const Numbered* from_right = nullptr;
      if (i < left.size() && left[i].event == event) {
        from_left = &left[i++];
        in_left = from_left->boundary.entering;
      }
      if (j < right.size() && right[j].event == event) {
        from_right = &right[j++];
        in_right = from_right->boundary.entering;
      }
      const bool after = combined(operation, in_left, in_right);
      if (before == after) continue;
      const bool flipped = operation == Operation::difference;
      if (from_left && from_left->boundary.entering != after) from_left = nullptr;
      if (from_right && (from_right->boundary.entering != flipped) != after) from_right = nullptr;
      const Numbered* named = from_left ? from_left : from_right;
      if (from_left && from_right && precedes(from_right->boundary, from_left->boundary))
        named = from_right;
      result.push_back(*named);
      result.back().boundary.entering = after;
    }
    return result;
  };

  std::vector<List> stack;
  for (const Visit& visit : visits_) {
    const PolishStep& step = solid_.polish[visit.step];
    if (!visit.entered) {
      stack.emplace_back();
      continue;
    }
    if (step.is_leaf) {
      stack.push_back(std::move(of_leaf[step.leaf]));
      continue;
    }
    ++costs_.combinations;
    const List right = std::move(stack.back());
    stack.pop_back();
    stack.back() = combine(step.operation, stack.back(), right);
  }
  for (const Numbered& numbered : stack.front())
    if (reportable(numbered.boundary.t)) combined_.push_back(numbered.boundary);
}

template void Classifier<float>::gather_in_order(const RayCena<float>&, float);
template void Classifier<double>::gather_in_order(const RayCena<double>&, double);
template void Classifier<long double>::gather_in_order(const RayCena<long double>&, long double);
template void Classifier<float>::combine_all();
template void Classifier<double>::combine_all();
template void Classifier<long double>::combine_all();

}  // namespace sir
